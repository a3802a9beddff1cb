#!/usr/bin/env bash
# usage: unpack_kernel.sh
# The second choice beside build_kernel.sh, for qemu: Debian's packaged kernel, unpacked once for its
# version, and an initial file system with the modules that tests need. Prints the folder that holds
# them as `vmlinuz` and `initrd`. Exit code 77: cannot be had here, why.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

skip() { echo "skipped: no packaged kernel: $*" >&2; exit 77; }

modules=(virtio_pci 9p 9pnet_virtio overlay vivid uvcvideo vhci-hcd vgem)
for tool in qemu-system-x86_64 busybox apt-get dpkg-deb; do
    command -v $tool >/dev/null || skip "no $tool"
done
package=$(apt-cache depends linux-image-amd64 2>/dev/null | grep -om 1 'linux-image-[0-9].*') ||
    skip "no package linux-image-amd64"
version=$(apt-cache policy "$package" | sed -n 's/^ *Candidate: //p')
made_by=$(sha256sum "$0" "$here/initrd.sh" | sha256sum)
folder=${XDG_CACHE_HOME:-$HOME/.cache}/autostereo
kernel=$folder/debian-kernel-$version-${made_by:0:8}

[[ ! -d $kernel ]] || { echo "$kernel"; exit; }
mkdir -p "$folder"
exec 9>"$folder/lock"
flock 9 # of two who want it one makes it
[[ ! -d $kernel ]] || { echo "$kernel"; exit; }
work=$(mktemp -d -p "${TMPDIR:-/tmp}")
trap 'rm -rf "$work"' EXIT
(cd "$work" && apt-get download -qq "$package" 2>log) || skip "$(tail -n 1 "$work/log")"
dpkg-deb -x "$work/$package"_*.deb "$work/image"
release=$(basename "$work"/image/lib/modules/*)
busybox depmod -b "$work/image" "$release"

# The modules in the order in which they are loaded, and busybox with what it links.
root=$work/initrd tree=$work/image/lib/modules/$release
mkdir -p "$root"/{bin,lib64,proc,host,modules} "$work/made"
for module in "${modules[@]}"; do
    line=$(grep -E "/$module\.ko:" "$tree/modules.dep") || skip "the kernel has no module $module"
    for file in $(tr ' ' '\n' <<<"${line#*:}" | tac) "${line%%:*}"; do
        grep -qsx "$(basename "$file")" "$root/modules/order" || {
            cp "$tree/$file" "$root/modules"
            basename "$file" >>"$root/modules/order"
        }
    done
done
cp "$(command -v busybox)" "$root/bin"
for library in $(ldd "$(command -v busybox)" 2>/dev/null | grep -o '/[^ ]*'); do
    install -D "$library" "$root$library"
done
install -m 755 "$here/initrd.sh" "$root/init"
(cd "$root" && find . | busybox cpio -o -H newc 2>/dev/null) | gzip -1 >"$work/made/initrd"
cp "$work/image/boot/vmlinuz-$release" "$work/made/vmlinuz"
mv "$work/made" "$kernel"
echo "$kernel"
