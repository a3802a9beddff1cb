#!/bin/sh
# The guest's first process, as root of a kernel of its own: the host's files below an overlay in memory,
# so that whatever is written vanishes, then the command in $exchange/command; its exit code goes to
# $exchange/status.
export PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root
mount -t proc proc /proc
for word in $(cat /proc/cmdline); do
    case $word in exchange=*) exchange=${word#exchange=} ;; esac
done
mount -t tmpfs -o size=75% tmpfs /mnt && mkdir /mnt/upper /mnt/work /mnt/root
mount -t overlay -o lowerdir=/,upperdir=/mnt/upper,workdir=/mnt/work overlay /mnt/root
cd /mnt/root || busybox poweroff -f
mkdir -p exchange
mount -t hostfs none exchange -o "$exchange"
mount -t proc proc proc
mount -t sysfs sysfs sys
mount -t devtmpfs devtmpfs dev
mkdir -p dev/shm dev/pts
mount -t devpts devpts dev/pts
for folder in dev/shm run; do mount -t tmpfs tmpfs $folder; done
chmod 1777 dev/shm
# vgem is a card that no GL driver knows; what wants it finds it here.
mv dev/dri dev/vgem
busybox ifconfig lo up
chroot . /bin/bash /exchange/command </dev/null
echo $? >exchange/status
busybox poweroff -f
