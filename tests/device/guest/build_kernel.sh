#!/usr/bin/env bash
# usage: build_kernel.sh
# Builds a user-mode Linux kernel from Debian's linux-source package with what kernel.config names, and
# prints its path. It is built once for a version of the package and of kernel.config (a few minutes);
# it runs as an ordinary program, without root, KVM or qemu. Exit code 77: cannot be built here, why.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

skip() { echo "skipped: no guest kernel: $*" >&2; exit 77; }

needed=(CONFIG_{HOSTFS,OVERLAY_FS,USBIP_VHCI_HCD,VIDEO_VIVID,USB_VIDEO_CLASS,DRM_VGEM})
sources=$(find /usr/src -maxdepth 1 -name 'linux-source-*.tar.xz' 2>/dev/null | sort -V | tail -n 1)
[[ -n $sources ]] || skip "package linux-source is not installed"
package=$(basename "$sources" .tar.xz)
version=$(dpkg-query -W -f='${Version}' "$package" 2>/dev/null) || version=${package##*-}
config=$(sha256sum "$here/kernel.config")
folder=${XDG_CACHE_HOME:-$HOME/.cache}/autostereo
kernel=$folder/uml-$version-${config:0:8}
for tool in make gcc flex bison bc xz; do
    command -v $tool >/dev/null || [[ -x $kernel ]] || skip "no $tool"
done

# Another version may be in the making, for minutes.
[[ ! -x $kernel ]] || { echo "$kernel"; exit; }
mkdir -p "$folder"
exec 9>"$folder/lock"
flock 9 # of two who want it one builds it
if [[ ! -x $kernel ]]; then
    work=$(mktemp -d -p "${TMPDIR:-/tmp}")
    trap 'rm -rf "$work"' EXIT
    log=$work/log
    echo "building a guest kernel from $package $version, a few minutes, once" >&2
    tar -xJf "$sources" -C "$work"
    compiler=gcc
    ! command -v ccache >/dev/null || compiler='ccache gcc'
    cd "$work/$package"
    {
        make ARCH=um KCONFIG_ALLCONFIG="$here/kernel.config" allnoconfig
        for option in "${needed[@]}"; do
            grep -q "^$option=y" .config || { echo "the kernel did not take $option=y"; exit 1; }
        done
        make ARCH=um CC="$compiler" -j "$(nproc)" linux
        strip -o "$work/kernel" linux
    } </dev/null >"$log" 2>&1 || { tail -n 20 "$log" >&2; exit 1; }
    mv "$work/kernel" "$kernel.new"
    mv "$kernel.new" "$kernel" # a cut-off copy is never taken for a kernel
fi
echo "$kernel"
