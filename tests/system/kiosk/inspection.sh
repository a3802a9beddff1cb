#!/bin/bash
# What is looked at inside the virtual machine, in order; the last line tells. Times are those of a
# machine a tenth as fast as a kiosk.
set -u
export DISPLAY=:0 XDG_RUNTIME_DIR=/run/autostereo WAYLAND_DISPLAY=wayland-0
server=$(</exchange/server)
settings=/etc/autostereo/autostereo.toml
monitor=$(echo /sys/class/drm/card*-Virtual-1)

say() { printf '%6.1f s  %s\n' "$(cut -d' ' -f1 /proc/uptime)" "$*"; }
fail() {
    say "FAILED: $*"
    journalctl --no-pager -b -u autostereo -u autostereo-xorg | tail -n 60
    autostereo status
    jobs
    exit 1
}
# await SECONDS WHAT COMMAND...
await() {
    local end=$((SECONDS + $1)) what=$2
    until "${@:3}" >/dev/null 2>&1; do
        ((SECONDS < end)) || fail "no $what within $1 s"
        sleep 0.2
    done
    say "$what"
}
screenshot() {
    sleep 1 # the picture that is shown is on its way
    case $server in
    xorg) xwd -root -silent >"/exchange/$1.xwd" ;;
    cage) grim "/exchange/$1.png" ;;
    esac || fail "no screenshot"
}
shows() { autostereo status | grep -q "^shows: $1"; }
field() { systemctl show -P "$1" autostereo; }
powered() { [[ $(<"$monitor/dpms") == "$1" ]]; }
restarted() { [[ $(field NRestarts) -gt $1 ]]; }
# configure TEXT: the settings and TEXT, which has to be good.
configure() {
    { cat /exchange/autostereo.toml; printf '%s\n' "$1"; } >"$settings"
    systemctl reload autostereo || fail "no reload of $1"
}

nice -n -5 /exchange/plugged_kinect2 2 & # it takes its time, a machine that is slow and busy
# 1. Nobody has touched anything.
await 60 "live picture after the boot" shows live
screenshot boot
[[ $(field User) == autostereo && $(field MainPID) != 0 ]] || fail "not as its own user"
(($(stat -c %u "/proc/$(field MainPID)") >= 61184)) || fail "not as a dynamic user"

# 2. It hangs: the watchdog ends it. It dies: it is started anew. The display server dies: both are.
# after WHAT COMMAND...: it is started anew, and shows a picture.
after() {
    local before
    before=$(field NRestarts)
    "${@:2}" || fail "cannot: $1"
    await 60 "restart after $1" restarted "$before"
    await 60 "live picture after $1" shows live
}
kill_program() {
    local pid
    for pid in $(</sys/fs/cgroup/system.slice/autostereo.service/cgroup.procs); do
        [[ $(</proc/$pid/comm) != "$1" ]] || kill -KILL "$pid"
    done
}
after "a hang" systemctl kill --signal=STOP autostereo
journalctl -b -u autostereo | grep -q "Watchdog timeout" || fail "it was not the watchdog"
after "a kill" kill_program autostereo
case $server in
xorg) after "the X server's death" systemctl kill --signal=KILL autostereo-xorg ;;
cage) after "the compositor's death" kill_program cage ;;
esac

# 3. From inside its sandbox it opens cameras: one of V4L2, and a Kinect v2 over libusb.
sed -i 's|^uri.*|&\ncolor = "v4l2:/dev/video0"|' "$settings"
systemctl reload autostereo || fail "no reload with a camera"
streaming() { autostereo status | grep -q "^$1: streaming"; }
await 30 "colour from the kernel's camera" streaming color
plugged() { grep -q 02d8 /sys/bus/usb/devices/*/idProduct; }
await 60 "a Kinect v2 on the bus" plugged
sed 's|^uri.*|uri = "kinect2:"|' /exchange/autostereo.toml >"$settings"
systemctl reload autostereo || fail "no reload with a Kinect v2"
await 60 "depth from a Kinect v2" streaming depth
kill %1
configure ""
echo 'uri = ' >"$settings"
systemctl reload autostereo && fail "a bad configuration is taken"
shows live || fail "a bad configuration ends the picture"
configure ""

# 4. The monitor is on by day and off by night (compositors have no DPMS).
if [[ $server == xorg ]]; then
    powered On || fail "the monitor is not on"
    day=$(date -d '+3 days' +%a)
    configure "[rest]
hours = [\"${day,,} 09:00-10:00\"]
monitor_off_s = 1"
    await 20 "monitor off after closing time" powered Off
    sleep 2
    powered Off || fail "the monitor did not stay off"
    shows closed || fail "not closed"
    configure ""
    began=$(date +%s%N)
    await 5 "monitor on again" powered On
    say "$((($(date +%s%N) - began) / 1000000)) ms after the reload was done"
    await 20 "live picture after opening" shows live
fi
screenshot opened

# 5. An upgrade keeps the configuration and shows a picture; a purge leaves nothing.
echo '# changed by hand' >>"$settings"
before=$(field MainPID)
dpkg -i /exchange/autostereo_1.1.0_amd64.deb >/dev/null 2>&1 || fail "no upgrade"
tail -n 1 "$settings" | grep -q 'by hand' || fail "the upgrade loses the configuration"
[[ $(field MainPID) != "$before" ]] || fail "the old program runs on after the upgrade"
await 60 "live picture after the upgrade" shows live
dpkg --purge autostereo >/dev/null 2>&1 || fail "no purge"
systemctl is-active --quiet autostereo && fail "it runs on after the purge"
left=$(find / -xdev \( -path /exchange -o -path /old -o -path /var/log/journal \) -prune -o \
    -name '*autostereo*' -print | grep -v '^/etc/systemd/system/autostereo.*\.d$')
[[ -z $left ]] || fail "the purge leaves $left"
getent passwd autostereo && fail "the purge leaves a user"
say "nothing left after the purge"
echo passed
