#!/bin/sh
# What a technician does on a new kiosk, in a system that is not running yet.
set -e
dpkg -i /exchange/autostereo_1.0.0_amd64.deb
cp /exchange/autostereo.toml /exchange/small.toml /etc/autostereo/
conf=/etc/systemd/system
mkdir -p $conf/autostereo.service.d $conf/autostereo-xorg.service.d $conf/seatd.service.d
server=$(cat /exchange/server)
case $server in
xorg) systemctl enable autostereo-xorg ;;
cage) ln -s /usr/share/autostereo/cage.conf $conf/autostereo.service.d/ ;;
esac

# This machine has no virtual terminals, a card that no GL driver knows, and one processor, whose first
# touch of a page costs 0.2 ms: what was freed is kept, and the watchdog has more patience.
card=/dev/dri/card1
printf '[Service]\nExecStart=\nExecStart=/usr/bin/Xorg :0 -seat kiosk -nolisten tcp -noreset -s 0\n' \
    >$conf/autostereo-xorg.service.d/machine.conf
printf '[Service]\nEnvironment=SEATD_VTBOUND=0\n' >$conf/seatd.service.d/machine.conf
printf '%s\n' '[Service]' WatchdogSec=25 'Environment=LP_NUM_THREADS=0 WLR_RENDERER=pixman' \
    "Environment=WLR_DRM_DEVICES=$card" \
    Environment=GLIBC_TUNABLES=glibc.malloc.mmap_threshold=33554432:glibc.malloc.trim_threshold=2147483647 \
    >$conf/autostereo.service.d/machine.conf
mkdir -p /etc/X11/xorg.conf.d
cat >/etc/X11/xorg.conf.d/machine.conf <<CONF
Section "Device"
    Identifier "virtual"
    Driver "modesetting"
    Option "kmsdev" "$card"
    Option "AccelMethod" "none"
EndSection
CONF
systemctl mask getty.target console-getty.service

cat >$conf/inspection.service <<UNIT
[Unit]
After=multi-user.target
[Service]
Type=oneshot
ExecStart=/bin/bash /exchange/inspection.sh
StandardOutput=file:/exchange/inspection.log
StandardError=inherit
ExecStopPost=/usr/bin/systemctl poweroff --force
UNIT
mkdir -p $conf/graphical.target.wants
ln -s ../inspection.service $conf/graphical.target.wants/
systemd-machine-id-setup
