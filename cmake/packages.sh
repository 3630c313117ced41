# Sourced by cases/run and tests/run: the Debian packages that bondstatic needs, and how they are installed and a
# preset is built. Progress goes to standard error; logs are shown only where something fails.

# libopenblas0-pthread by name: libsuitesparse-dev is content with the much slower reference BLAS.
solver_packages=(g++ cmake ninja-build libeigen3-dev libfmt-dev libcli11-dev libtomlplusplus-dev
                 nlohmann-json3-dev libqd-dev libsuitesparse-dev libopenblas0-pthread libspectra-dev
                 libceres-dev libboost-dev libpugixml-dev zlib1g-dev)
# Of the page of reports, whose parts npm brings. Another npm than Debian's will do, and could not stand beside it.
page_packages=()
command -v npm >/dev/null && command -v node >/dev/null || page_packages=(nodejs npm)
# PETSc brings MPI and about 90 packages: only for those who ask for it, and for the tests.
petsc_packages=(petsc-dev pkgconf)
# Of the Python module, its examples and its tests.
python_packages=(pybind11-dev python3-dev python3-numpy python3-scipy python3-matplotlib)
# chromium opens reports. The last three are other codes, whose files are read: yade brings about 100 packages.
test_packages=(libgtest-dev libgmock-dev python3 python3-vtk9 mypy gnuplot-nox chromium lammps liggghts yade)

say() { echo "bondstatic: $*" >&2; }

# run_logged LOG COMMAND...: quiet, unless the command fails.
run_logged() {
  local log=$1 status=0
  shift
  mkdir -p "$(dirname "$log")"
  "$@" >"$log" 2>&1 || status=$?
  if [ "$status" -ne 0 ]; then
    cat "$log" >&2
    say "failed (exit $status): $*"
  fi
  return "$status"
}

missing_packages() {
  local package installed
  # A removed package's leftovers are known to dpkg-query, too: only the status "installed" counts.
  installed=$(dpkg-query -W -f '${Package}=${db:Status-Status}\n' "$@" 2>/dev/null) || true
  for package in "$@"; do
    grep -qxF "$package=installed" <<<"$installed" || echo "$package"
  done
}

apt_install() {
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600)
  "${as_root[@]}" "${apt[@]}" update && "${as_root[@]}" "${apt[@]}" install -y --no-install-recommends "$@"
}

# install_packages ROOT PACKAGE...
install_packages() {
  local root=$1 missing as_root=()
  shift
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "not a Debian system: install yourself what matches the Debian packages $*"
    return 0
  fi
  # Names split at blanks, not by <(...): a bare chroot has no /dev/fd.
  # shellcheck disable=SC2207
  missing=($(missing_packages "$@"))
  [ ${#missing[@]} -eq 0 ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
    if ! command -v sudo >/dev/null || ! sudo -v; then
      say "needs these Debian packages, and you are neither root nor may you use sudo. Let an administrator run:"
      say "  apt-get install --no-install-recommends ${missing[*]}"
      return 1
    fi
  fi
  say "installing ${missing[*]}"
  run_logged "$root/build/packages.log" apt_install "${missing[@]}"
}

# build_preset ROOT PRESET: configures once; from then on the build itself notices changes.
build_preset() (
  cd "$1" || return
  if [ ! -f "build/$2/build.ninja" ]; then
    say "building preset '$2' (several minutes, once)"
    run_logged "build/$2/configure.log" cmake --preset "$2" || return
  fi
  run_logged "build/$2/build.log" cmake --build --preset "$2" --parallel "$(nproc)"
)
