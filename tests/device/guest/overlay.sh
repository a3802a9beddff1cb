# What a guest's first process does first; sourced by sh. Its files get an overlay in memory, so that
# whatever is written vanishes: the folder this leaves one in, with /proc and the host's $exchange.
# shellcheck shell=sh
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
mount -t proc proc /proc
for word in $(cat /proc/cmdline); do
    case $word in exchange=*) exchange=${word#exchange=} ;; esac
done
mount -t tmpfs -o size=75% tmpfs /mnt && mkdir /mnt/upper /mnt/work /mnt/root
mount -t overlay -o lowerdir=/,upperdir=/mnt/upper,workdir=/mnt/work overlay /mnt/root
cd /mnt/root || exit 1
mkdir -p exchange
if grep -q hostfs /proc/filesystems; then
    mount -t hostfs none exchange -o "$exchange"
else # in qemu
    mount -t 9p -o trans=virtio,version=9p2000.L,msize=512000 exchange exchange
fi
mount -t proc proc proc
