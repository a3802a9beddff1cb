#!/bin/busybox sh
# shellcheck shell=dash disable=SC2013 # names of modules are words
# First process of the packaged kernel in qemu: its modules, then the host's files, which it shares by
# 9p, and from them what a user-mode kernel begins with (init=).
export PATH=/bin
busybox mount -t proc proc /proc
for module in $(busybox cat /modules/order); do
    case $module in vivid.ko) set -- n_devs=1 node_types=0x1 num_inputs=1 input_types=0 ;; *) set -- ;; esac
    busybox insmod "/modules/$module" "$@" || echo "no module $module"
done
for word in $(busybox cat /proc/cmdline); do
    case $word in guest_init=*) init=${word#guest_init=} ;; esac
done
busybox mount -t 9p -o trans=virtio,version=9p2000.L,msize=512000,cache=loose,ro root /host
busybox umount /proc
exec busybox switch_root /host "$init"
