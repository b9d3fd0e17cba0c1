#!/usr/bin/env bash
# Makes the Debian packages and looks at them as a user does: what they say of themselves, that apt finds
# what they need, that they install, the installed program runs, and they go without a trace. Only root can
# install; without root the rest is done and the status is 77, or 1 where something is wrong.
# Usage: check_debian_packages.sh CPACK CPACK_CONFIGURATION VERSION SOURCE_FOLDER
set -euo pipefail
export LC_ALL=C
cpack="$1" configuration="$2" version="$3" source="$4"

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
failed=0
complain() {
  echo "$*" >&2
  failed=1
}

# Fast in place of small: how much they are compressed is of no matter here.
"$cpack" --config "$configuration" -B "$folder" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip
architecture="$(dpkg --print-architecture)"
program="$folder/microslip_${version}_$architecture.deb"
library="$folder/libmicroslip-dev_${version}_$architecture.deb"
python="$folder/python3-microslip_${version}_$architecture.deb"
packages=("$program" "$library" "$python")
for package in "${packages[@]}"; do
  [[ -f $package ]] || { complain "made: $(ls "$folder")"; exit 1; }
done

# What they say.
field() { dpkg-deb --field "$@"; }
[[ "$(field "$program" Version)" == "$version" ]] || complain "version $(field "$program" Version)"
for need in libc6 libfmt libmumps-seq libstdc++ libtbb zlib1g; do
  [[ "$(field "$program" Depends)" == *"$need"* ]] || complain "microslip does not depend on $need"
done
[[ "$(field "$program" Recommends)" == *gnuplot* ]] || complain "microslip does not recommend gnuplot"
[[ "$(field "$program" Recommends)" == *"gcc | c-compiler"* ]] || complain "microslip does not recommend a C compiler"
for need in libfmt-dev libhdf5-dev libtbb-dev zlib1g-dev; do
  [[ "$(field "$library" Depends)" == *"$need"* ]] || complain "libmicroslip-dev does not depend on $need"
done
for need in "python3 (>= 3" python3-numpy libhdf5 libtbb; do
  [[ "$(field "$python" Depends)" == *"$need"* ]] || complain "python3-microslip does not depend on $need"
done
for package in "${packages[@]}"; do
  [[ -z "$(dpkg-deb --contents "$package" | grep -Ev '^(-rw-r--r--|-rwxr-xr-x|drwxr-xr-x|lrwxrwxrwx) root/root ')" ]] ||
    complain "$package: owners or modes of $(dpkg-deb --contents "$package")"
done
changelog="$(dpkg-parsechangelog --file "$source/cmake/debian/changelog" --show-field Version)"
[[ $changelog == "$version" ]] || complain "cmake/debian/changelog begins with $changelog, not $version"

# What they hold, apart from each other.
tree="$folder/tree"
mkdir "$tree"
for package in "${packages[@]}"; do
  name="$(field "$package" Package)"
  dpkg-deb --extract "$package" "$tree/$name"
  for file in "usr/share/doc/$name/copyright" "usr/share/doc/$name/changelog.gz"; do
    [[ -s $tree/$name/$file ]] || complain "$name has no $file"
  done
  (cd "$tree/$name" && find . ! -type d) | sort >"$folder/$name.files"
done
common="$(cat "$folder"/*.files | sort | uniq -d)"
[[ -z $common ]] || complain "in more than one: $common"
for file in usr/bin/microslip usr/share/man/man1/microslip.1.gz \
  usr/share/man/man1/microslip-identify.1.gz usr/share/bash-completion/completions/microslip \
  usr/share/zsh/vendor-completions/_microslip usr/share/doc/microslip/docs/commands.md; do
  [[ -s $tree/microslip/$file ]] || complain "microslip has no $file"
done
for file in usr/lib/libmicroslip_{core,measurement,files,report}.a usr/lib/cmake/microslip/microslipConfig.cmake \
  usr/lib/pkgconfig/microslip.pc usr/include/microslip/joint/joint.hpp usr/lib/libmicroslip_c.so \
  usr/lib/pkgconfig/microslip-c.pc usr/include/microslip.h usr/include/microslip.f90; do
  [[ -s $tree/libmicroslip-dev/$file ]] || complain "libmicroslip-dev has no $file"
done
for file in __init__.py _core.pyi py.typed microslip-hdf5-reader; do
  [[ -e $tree/python3-microslip/usr/lib/python3/dist-packages/microslip/$file ]] ||
    complain "python3-microslip has no $file"
done
traces="$(grep -rlF -e "$source" -e "$folder" "$tree" || true)"
[[ -z $traces ]] || complain "folders of the build in: $traces"

bash "$(dirname "${BASH_SOURCE[0]}")/../docs_checks/check_links.sh" "$tree/microslip/usr/share/doc/microslip" \
  links || complain "documents lead to what is not in the package"

# What they need is in this Debian.
if command -v apt-get >/dev/null; then
  apt-get install --simulate --no-install-recommends "${packages[@]}" >"$folder/log" 2>&1 ||
    { complain "apt cannot install:"; cat "$folder/log" >&2; }
else
  echo "No apt: dependencies are not resolved."
fi

# use ROOT: the program of that root does all that it can, in an environment without anything.
use() {
  local run=(env -i PATH=/usr/bin:/bin HOME="$folder" "$1/usr/bin/microslip")
  local example="$1/usr/share/doc/microslip/examples/reference_rig"
  rm -rf "$folder/work"
  mkdir "$folder/work"
  cd "$folder/work"
  [[ "$("${run[@]}" --version)" == "microslip $version" ]] || complain "--version is not $version"
  "${run[@]}" demo --quiet --out demo || complain "the demonstration failed"
  local report
  for report in reference_rig brake_reuss_beam; do
    [[ -s demo/$report/report.html ]] || complain "the demonstration wrote no report of $report"
  done
  [[ -n "$(find demo -name '*.svg' -size +1k)" ]] || complain "the demonstration drew nothing"
  "${run[@]}" reduce "$example/rig.toml" "$example"/recordings/*.csv --quiet --out levels.csv ||
    complain "the example failed"
  cd "$folder"
}

# use_python ROOT: the module of that root finds a joint, and what reads files of HDF5.
use_python() {
  env -i PATH=/usr/bin:/bin PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$1/usr/lib/python3/dist-packages" \
    /usr/bin/python3 - "$folder/draws.h5" <<'END' || complain "the package of Python failed"
import sys
import numpy as np
import microslip
joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
amplitude = np.linspace(2e-6, 1e-4, 40)
found = microslip.identify(amplitude, joint.dissipation(amplitude), stiffness=1e5, samples=20)
found.draws.write(sys.argv[1])
assert microslip.JointDraws.read(sys.argv[1])[3] == found.draws[3]
END
}

# In, at work, and out. An empty system has none of what they depend on, so the program takes it from this one.
if [[ $EUID -eq 0 ]]; then
  root="$folder/root"
  mkdir -p "$root"/var/lib/dpkg/{info,updates,triggers}
  touch "$root/var/lib/dpkg/status" "$root/var/lib/dpkg/available"
  present() { (cd "$root" && find . -path ./var -prune -o ! -path . -print); }
  dpkg --root="$root" --force-depends --install "${packages[@]}" >"$folder/log" 2>&1 ||
    { complain "not installed:"; cat "$folder/log" >&2; }
  use "$root"
  use_python "$root"
  [[ -z "$(dpkg --root="$root" --verify)" ]] || complain "$(dpkg --root="$root" --verify)"
  dpkg --root="$root" --purge python3-microslip libmicroslip-dev microslip >"$folder/log" 2>&1 ||
    { complain "not removed:"; cat "$folder/log" >&2; }
  [[ -z "$(present)" ]] || complain "left behind: $(present)"
else
  use "$tree/microslip"
  use_python "$tree/python3-microslip"
fi

# Debian's own inspector, where there is one. Nothing is uploaded to Debian, and nothing is there to be
# compiled for another machine.
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error,warning \
    --suppress-tags initial-upload-closes-no-bugs,pkg-config-unavailable-for-cross-compilation \
    "${packages[@]}" || complain "lintian complains"
fi

((failed == 0)) || exit 1
if [[ $EUID -ne 0 ]]; then
  echo "Partly tested: not root, so the packages were unpacked and used, but not installed and removed." >&2
  exit 77
fi
