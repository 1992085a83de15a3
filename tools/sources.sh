# shellcheck shell=sh disable=SC2034,SC2154
# Sourced after tools/setup.sh by what compiles libpulloff together with the libraries that it needs: reports/live/build.sh and
# python/wheels.sh. get_sources downloads GSL, nettle and jansson as Debian's source packages into the folder $sources, once.
sources=$(pwd)/$build/sources

# download_sources: with an apt of its own, whose sources are the source packages of this system's
download_sources() {
  apt=$sources/apt
  mkdir -p "$apt/sources" "$apt/state/lists/partial" "$apt/cache/archives/partial" "$sources/include"
  for list in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    [ ! -f "$list" ] || sed 's/^deb /deb-src /; s/^Types:.*/Types: deb-src/' "$list" >"$apt/sources/$(basename "$list")"
  done
  apt_of_sources() {
    apt-get -q -o "Dir::State=$apt/state" -o "Dir::Cache=$apt/cache" -o Dir::Etc::SourceList=/dev/null \
      -o "Dir::Etc::SourceParts=$apt/sources" -o Dir::State::status=/var/lib/dpkg/status -o APT::Sandbox::User=root "$@"
  }
  apt_of_sources update || echo 'some lists of source packages cannot be downloaded'
  (cd "$apt" && apt_of_sources source --download-only gsl jansson nettle) || return 1
  for name in gsl jansson nettle; do
    mkdir -p "$sources/$name"
    tar -x --strip-components 1 -C "$sources/$name" -f "$apt/$name"_*.orig.tar.?z || return 1
  done
  # The headers of this system's packages without those of its C library, which stand beside them.
  for header in gsl nettle jansson.h jansson_config.h; do ln -sfn "/usr/include/$header" "$sources/include/"; done
  : >"$sources/include/config.h"
  : >"$sources/include/jansson_private_config.h"
  : >"$sources/complete"
}

get_sources() {
  [ -f "$sources/complete" ] || step 'Downloading sources' download_sources
}
