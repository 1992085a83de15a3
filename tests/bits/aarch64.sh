#!/bin/sh
# Builds the program for aarch64 and compares the digests of its results, run by qemu, with those of scenes.txt. Installs a
# cross compiler and qemu with tools/setup.sh; the libraries of that architecture are unpacked into build-aarch64/root,
# beside nothing of this system.
set -u
cd "$(dirname "$0")/../.." || exit 4
command_name=aarch64
. tools/setup.sh
at=$(pwd)/build-aarch64
root=$at/root
mkdir -p "$at" "$log_folder"
start_log
install_packages gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user-static

# An apt of its own, which sees only that architecture. The sources of packages are those of this system.
apt_of_root() {
  apt-get -q -o "Dir::State=$at/apt/state" -o "Dir::State::status=$at/apt/status" \
    -o "Dir::Cache=$at/apt/cache" -o APT::Architecture=arm64 -o APT::Architectures::=arm64 \
    -o APT::Sandbox::User=root -o Debug::NoLocking=true "$@"
}
download() {
  mkdir -p "$at/apt/state/lists/partial" "$at/apt/cache/archives/partial"
  : >"$at/apt/status"
  apt_of_root update &&
    apt_of_root -y --no-install-recommends --download-only install libgsl-dev liblapacke-dev libopenblas-dev \
      libopenblas-pthread-dev libyaml-dev libjansson-dev nettle-dev libgomp1 libc6
}
unpack() {
  for package in "$at"/apt/cache/archives/*.deb; do
    dpkg-deb -x "$package" "$root" || return 1
  done
  # The alternatives that the scripts of the packages would choose.
  (
    cd "$root/usr/lib/aarch64-linux-gnu" || exit 1
    for library in openblas-pthread/lib*.so*; do ln -sf "$library" .; done
    for name in blas lapack; do ln -sf "../openblas-pthread/pkgconfig/$name-openblas.pc" "pkgconfig/$name.pc"; done
    ln -sf ../openblas-pthread/pkgconfig/openblas.pc pkgconfig/openblas.pc
  )
}
if [ ! -f "$at/unpacked" ]; then
  step 'Downloading for aarch64' download
  step 'Unpacking for aarch64' unpack
  : >"$at/unpacked"
fi

cat >"$at/cross.ini" <<INI
[binaries]
c = 'aarch64-linux-gnu-gcc'
ar = 'aarch64-linux-gnu-ar'
strip = 'aarch64-linux-gnu-strip'
pkgconfig = 'pkg-config'
[properties]
sys_root = '$root'
pkg_config_libdir = ['$root/usr/lib/aarch64-linux-gnu/pkgconfig', '$root/usr/share/pkgconfig']
[built-in options]
c_args = ['-isystem', '$root/usr/include', '-isystem', '$root/usr/include/aarch64-linux-gnu']
c_link_args = ['-L$root/usr/lib/aarch64-linux-gnu', '-Wl,-rpath-link,$root/usr/lib/aarch64-linux-gnu:$root/lib/aarch64-linux-gnu']
[host_machine]
system = 'linux'
cpu_family = 'aarch64'
cpu = 'aarch64'
endian = 'little'
INI
build_targets=src/cli/pulloff:executable
configure_and_build "$at/build" ', aarch64' -Dtests=false --cross-file "$at/cross.ini"
exec python3 tests/bits/bits.py --emulator "qemu-aarch64-static -L $root" \
  aarch64="$at/build/src/cli/pulloff"
