# How a guest is started; sourced by bash, never run. A user-mode kernel (see build_kernel.sh), else
# the packaged one in qemu (see unpack_kernel.sh), where numbers cost up to 150 times as much unless
# the machine has KVM; AUTOSTEREO_GUEST=uml or qemu: no other.
# shellcheck shell=bash

# required CODE: ends with CODE; where everything is installed a test has no excuse to skip (77).
required() { [[ $1 != 77 || ,${AUTOSTEREO_REQUIRE:-}, != *,device,* ]] || exit 1; exit "$1"; }

# prepare_guest: sets kernel, whether it is packaged, and exchange, a folder that the guest sees and that goes at the end.
# The guest's memory is a file, in memory_folder: one in memory is faster where there is room for it.
prepare_guest() {
    local here choice=${AUTOSTEREO_GUEST:-} code=77
    here=$(dirname "${BASH_SOURCE[0]}")
    kernel='' packaged=0
    [[ $choice == qemu ]] || { code=0; kernel=$("$here/build_kernel.sh") || code=$?; }
    if ((code == 77)) && [[ $choice != uml ]]; then
        packaged=1 code=0
        kernel=$("$here/unpack_kernel.sh") || code=$?
    fi
    ((code == 0)) || required $code
    memory_mib=2048 memory_folder=${TMPDIR:-/tmp}
    (($(df --output=avail -m /dev/shm 2>/dev/null | tail -n 1 || echo 0) <= memory_mib)) ||
        memory_folder=/dev/shm
    exchange=$(mktemp -d -p "$memory_folder")
    trap 'rm -rf "$exchange"' EXIT
}

# boot_guest SECONDS ROOT INIT [COMMAND...]: what its console says, for at most SECONDS; ROOT is the
# folder it has as its files, INIT its first process in there, COMMAND what starts the kernel.
boot_guest() {
    ((!packaged)) || { boot_qemu "$@"; return; }
    TMPDIR=$memory_folder timeout --foreground -k 5 "${AUTOSTEREO_GUEST_SECONDS:-$1}" \
        "${@:4}" "$kernel" mem="${memory_mib}M" root=/dev/root rootfstype=hostfs rootflags="$2" ro \
        init="$3" exchange="$exchange" uml_dir="$exchange/" \
        con=null con0=fd:0,fd:1 console=tty0 quiet \
        vivid.n_devs=1 vivid.node_types=0x1 vivid.num_inputs=1 vivid.input_types=0 </dev/null 2>&1
}

# boot_qemu: the same of the packaged kernel.
boot_qemu() {
    local processor=(-accel "tcg,thread=multi" -cpu max)
    # A nested host may offer KVM and yet emulate each instruction.
    [[ ! -w /dev/kvm || ! (-d /sys/module/kvm_intel || -d /sys/module/kvm_amd) ]] ||
        processor=(-accel kvm -cpu host)
    share() { # TAG FOLDER ON|OFF: read only
        printf '%s\n' -fsdev "local,id=$1,path=$2,security_model=none,readonly=$3,multidevs=remap" \
            -device "virtio-9p-pci,fsdev=$1,mount_tag=$1"
    }
    local shares
    mapfile -t shares < <(share root "$2" on; share exchange "$exchange" off)
    timeout --foreground -k 5 "${AUTOSTEREO_GUEST_SECONDS:-$1}" \
        "${@:4}" qemu-system-x86_64 "${processor[@]}" -M q35 -m "$memory_mib" -nodefaults -no-user-config \
        -display none -no-reboot -serial stdio "${shares[@]}" \
        -kernel "$kernel/vmlinuz" -initrd "$kernel/initrd" \
        -append "console=ttyS0 quiet panic=-1 mitigations=off guest_init=$3" </dev/null 2>&1
}
