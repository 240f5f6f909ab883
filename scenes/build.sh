# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by scenes/run.sh and tests/run.sh (POSIX sh), in the top folder of the project.

# Prints the packages of scenes/packages.txt that are not installed.
find_missing_packages() {
  sed 's/#.*//' scenes/packages.txt | while read -r package; do
    [ -n "$package" ] || continue
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || printf '%s ' "$package"
  done
}

# Installs what is missing: as root, or by sudo; else says what to install.
install_packages() {
  if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "This is not a Debian system: install what scenes/packages.txt names by your own means." >&2
    return 0
  fi
  missing=$(find_missing_packages)
  [ -z "$missing" ] || install_named "$missing"
}

# Installs the Debian packages that are named in one argument.
install_named() {
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
      echo "These Debian packages are missing: $1" >&2
      echo "Ask an administrator to run: apt-get install $1" >&2
      return 1
    fi
    as_root=sudo
  fi
  echo "Installing Debian packages: $1"
  # shellcheck disable=SC2086  # words on purpose
  if ! { $as_root apt-get update -qq && DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y --no-install-recommends $1; }; then
    echo "Could not install: $1" >&2
    echo "Install these Debian packages and start again: apt-get install $1" >&2
    return 1
  fi
}

# Configures and builds the release preset; arguments are targets (none: all).
build_release() {
  jobs=$(nproc 2>/dev/null || echo 2)
  # A gigabyte and a half for each compiler at work, or the machine begins to swap.
  memory_kb=$(sed -n 's/^MemAvailable: *\([0-9]*\).*/\1/p' /proc/meminfo 2>/dev/null)
  if [ -n "$memory_kb" ]; then
    fitting=$((memory_kb / 1500000))
    [ "$fitting" -ge 1 ] || fitting=1
    [ "$jobs" -le "$fitting" ] || jobs=$fitting
  fi
  cmake --preset release >build/configure.log 2>&1 || {
    cat build/configure.log >&2
    return 1
  }
  cmake --build build/release --parallel "$jobs" ${1:+--target "$@"}
}
