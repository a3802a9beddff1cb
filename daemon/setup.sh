# Packages and build steps shared by daemon/demo and tests/run; sourced by bash, never run.
# Every step first looks whether there is anything to do: a second run costs less than a second.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Clones in other folders share compiled objects.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

# Everything CMakeLists.txt asks for, and the software renderer for machines without a GPU.
build_packages=(
    g++ cmake ninja-build ccache pkg-config
    libegl-dev libopengl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri libglfw3-dev libxcb-dpms0-dev
    libglm-dev libspdlog-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev
    libpng-dev libturbojpeg0-dev libmatroska-dev libebml-dev libsystemd-dev
    libdrm-dev libusb-1.0-0-dev libopenni2-dev libcpp-httplib-dev libssl-dev
    libopencv-core-dev libopencv-imgproc-dev libopencv-calib3d-dev libopencv-contrib-dev
    libopencv-objdetect-dev opencv-data
)
# What tests/ needs beyond that. OpenCV is a second opinion, too.
test_packages=(
    libgtest-dev libgmock-dev libbenchmark-dev glslang-tools clang-format clang-tidy git
    clang libclang-rt-dev
    ffmpeg mkvtoolnix
    xvfb xauth xdotool x11-utils x11-apps x11-xserver-utils libxcb-xfixes0-dev
    libopencv-photo-dev chromium chromium-driver
    linux-source make gcc flex bison bc xz-utils busybox mmdebstrap dpkg-dev
)

say() { printf '== %s\n' "$*"; }
die() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; exit 1; }

# missing_packages PACKAGE...: those that are not installed, one a line.
missing_packages() {
    local installed package
    installed=$(dpkg-query -W -f=' ${db:Status-Status}:${Package} ' "$@" 2>/dev/null) || true
    for package; do
        [[ $installed == *" installed:$package "* ]] || echo "$package"
    done
}

# install_missing PACKAGE...: asks apt-get for what is missing, and only then for root.
install_missing() {
    command -v dpkg-query >/dev/null || die "no dpkg here: install by hand what Debian calls $*"
    local missing as_root=()
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]})) || return 0
    if ((EUID != 0)); then
        command -v sudo >/dev/null ||
            die "neither root nor sudo: as root, apt-get install ${missing[*]}"
        as_root=(sudo)
    fi
    say "installing ${missing[*]}"
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" ||
        die "cannot install ${missing[*]} (see apt-get above)"
}

# configure PRESET ON|OFF: OFF leaves the tests out, so that their packages are not needed, but a
# folder that has them keeps them. Later changes to CMake files are ninja's business.
configure() {
    local folder=$root/build/$1 has='' tests=$2
    [[ ! -f $folder/build.ninja ]] ||
        has=$(sed -n 's/^AUTOSTEREO_TESTS:BOOL=//p' "$folder/CMakeCache.txt")
    [[ $has != ON ]] || tests=ON
    [[ $has != "$tests" || $root/CMakePresets.json -nt $folder/build.ninja ]] || return 0
    say "configuring build/$1"
    cmake -S "$root" --preset "$1" -D AUTOSTEREO_TESTS="$tests" --log-level=WARNING
}

# build PRESET TARGET...
build() {
    say "building build/$1: ${*:2}"
    cmake --build "$root/build/$1" -j "$(nproc)" --target "${@:2}"
}
