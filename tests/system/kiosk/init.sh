#!/bin/sh
# First process of the virtual machine: the package is installed and set up as by a technician, then
# systemd takes over.
. "$(dirname "$0")/overlay.sh"
export DEBIAN_FRONTEND=noninteractive
mkdir -p old
chroot . /bin/sh /exchange/install.sh >exchange/install.log 2>&1
umount proc /proc
pivot_root . old
exec chroot . /lib/systemd/systemd
