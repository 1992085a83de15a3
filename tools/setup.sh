# shellcheck shell=sh disable=SC2154
# Sourced by ./reproduce, ./check and .ci/run: installs missing packages, configures, builds.
# The caller sets `command_name`. The current folder must be the root of the source tree.

build=build
log_folder=$build/log
log=$log_folder/$command_name.log

fail() {
  printf '%s: %s\n' "$command_name" "$*" >&2
  exit "${fail_status:-4}"
}

. tools/steps.sh

# listed_packages LIST...: prints the names of packages in these files
listed_packages() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$@"; }

# missing_packages NAME...: prints the packages that are not installed, on one line
missing_packages() {
  for package in "$@"; do
    state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) || state=absent
    [ "$state" = installed ] || printf '%s ' "$package"
  done
}

apt_install() {
  # If the package lists cannot be refreshed, the packages may still be found in the present lists.
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q update ||
    printf 'apt-get update failed; continuing with the present package lists\n'
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
    -o DPkg::Lock::Timeout=300 install "$@"
}

# install_packages NAME...: installs the missing packages. If none is missing, apt-get and sudo are not called.
install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this is not a Debian system (no dpkg-query and apt-get): install the equivalents of" \
      "the packages in tools/packages and rerun with --no-install"
  fi
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "not root, and sudo is not installed: ask an administrator to install ${missing% }"
    sudo -n true 2>/dev/null || sudo true ||
      fail "sudo was refused: ask an administrator to install ${missing% }"
    as_root=sudo
  fi
  # The list is split into words on purpose.
  # shellcheck disable=SC2086
  set -- $missing
  step 'Installing packages' apt_install "$@"
}

# forget_foreign_build DIR: removes the configuration of a build folder that belongs to a source tree at another place,
# or whose configuration was interrupted. Runs and reports in the folder are kept.
forget_foreign_build() {
  if [ -f "$1/meson-private/coredata.dat" ]; then
    if [ ! -f "$1/build.ninja" ] || [ "$(cat "$1/source-tree" 2>/dev/null)" != "$(pwd -P)" ]; then
      rm -rf "$1/meson-private" "$1/meson-info" "$1/build.ninja"
    fi
  fi
}

# configure DIR LABEL MESON-OPTION...
configure() {
  folder=$1
  suffix=$2
  shift 2
  forget_foreign_build "$folder"
  if [ ! -f "$folder/build.ninja" ]; then
    step "Configuring$suffix" meson setup "$folder" "$@"
    pwd -P >"$folder/source-tree"
  fi
}

# configure_and_build DIR LABEL MESON-OPTION...: builds $build_targets; if it is not set, everything.
configure_and_build() {
  configure "$@"
  # The list is split into words on purpose.
  # shellcheck disable=SC2086
  step "Building$suffix" meson compile -C "$folder" ${build_targets:-}
}

# set_sanitizer_options: for programs that are built with the address and undefined-behaviour sanitizers
#
# The address sanitizer of Clang 14 takes a block of thread-local storage whose address is 16 modulo 4096 for one that glibc
# 2.19 has allocated, and reads the bounds of the block from the two words before it. When the sanitizer itself has allocated
# the block, these words are its own, and the search for leaks ends with `Tracer caught signal 11`. Blocks allocated so belong
# to libraries that are loaded while the program runs (libstdc++, which libomp loads); whether one has such an address changes
# with the number of allocations before it. Without the interception these blocks are not searched for pointers.
set_sanitizer_options() {
  export ASAN_OPTIONS=intercept_tls_get_addr=0
  export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
}

# prepare: the set-up that ./reproduce and ./check have in common
prepare() {
  start_log
  if [ "$install" = yes ]; then
    # shellcheck disable=SC2046,SC2086
    install_packages $(listed_packages tools/packages ${more_packages:-})
  fi
  configure_and_build "$build" ''
}
