# shellcheck shell=bash
# Sourced by the findings: a temporary folder, pinned packages in it, and words for the end. Nothing is installed and
# no root is needed: packages that are missing are unpacked into the temporary folder, and the variables set here lead
# to the programs, libraries and modules in it.
set -euo pipefail
export LC_ALL=C OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

finding="$(basename "$0" .sh)"
work="$(mktemp -d)"
root="$work/root"
trap 'rm -rf "$work"' EXIT
cd "$work"

fail() { # WORDS: the behaviour is no longer that of the head comment, or could not be seen
  echo "$finding: $*" >&2
  exit 1
}

seen() { # WORDS: the behaviour is that of the head comment
  echo "$finding: seen: $*"
}

holds() { # EXPRESSION WORDS: awk judges the expression; the words say what was seen instead
  awk "BEGIN { exit !($1) }" </dev/null || fail "$2 ($1)"
}

apt_options=(-q -o APT::Sandbox::User= -o Acquire::Retries=3)

plan_packages() {
  apt-get "${apt_options[@]}" --simulate --no-install-recommends install "$@" >"$work/plan" 2>"$work/plan.log"
}

# Lists of packages of its own, where the machine has none or old ones.
read_own_lists() {
  mkdir -p "$work/apt/lists/partial" "$work/apt/cache/archives/partial"
  apt_options+=(-o "Dir::State::lists=$work/apt/lists" -o "Dir::Cache=$work/apt/cache")
  apt-get "${apt_options[@]}" update >"$work/apt.log" 2>&1 || fail "apt-get update: $(tail -n 1 "$work/apt.log")"
}

# Packages of Debian 12, NAME=VERSION each, with what they depend on. What is installed in that version is used as it
# is; all else is unpacked.
debian() {
  command -v apt-get >/dev/null || fail "needs Debian 12"
  if ! plan_packages "$@"; then
    read_own_lists
    plan_packages "$@" || fail "no such packages: $(tail -n 1 "$work/plan.log")"
  fi
  local missing archive
  mapfile -t missing < <(sed -nE 's/^Inst ([^ ]+) (\[[^]]*\] )?\(([^ ]+) .*/\1=\3/p' "$work/plan")
  mkdir -p "$root" "$work/archives"
  if ((${#missing[@]} > 0)); then
    (cd "$work/archives" && apt-get "${apt_options[@]}" download "${missing[@]}" >"$work/apt.log" 2>&1) ||
      fail "apt-get download: $(tail -n 1 "$work/apt.log")"
    for archive in "$work"/archives/*.deb; do
      dpkg-deb --extract "$archive" "$root"
    done
    rm -rf "$work/archives"
  fi

  local libraries folder
  libraries="/usr/lib/$(dpkg --print-architecture | sed -e 's/amd64/x86_64/' -e 's/arm64/aarch64/')-linux-gnu"
  export PATH="$root/usr/bin:/usr/bin:/bin:$PATH"
  export LD_LIBRARY_PATH="$root$libraries:$root${libraries#/usr}:$root/usr/lib"
  for folder in "$root$libraries"/{blas,lapack,octave/*,pulseaudio}; do
    [[ ! -d "$folder" ]] || LD_LIBRARY_PATH+=":$folder"
  done
  export PYTHONPATH="$root/usr/lib/python3/dist-packages"
  if [[ -x "$root/usr/bin/octave-cli" ]]; then
    export OCTAVE_HOME="$root/usr" OCTAVE_EXEC_HOME="$root/usr"
  fi
  if [[ -x "$root/usr/bin/orterun" ]]; then
    export OPAL_PREFIX="$root/usr" OPAL_LIBDIR="$root$libraries/openmpi/lib"
  fi
}

octave() { # SCRIPT: its output, without what Octave says of itself at its end
  octave-cli --quiet --no-history --no-init-file "$1" 2>octave.log || true
}

scilab() { # SCRIPT: the lines that it prints behind `seen `; all that Scilab says is in scilab.log
  local share="$root/usr/share/scilab" libraries="$root/usr/lib/scilab"
  [[ -d "$share" ]] || share=/usr/share/scilab libraries=/usr/lib/scilab
  SCI="$share" LD_LIBRARY_PATH="$libraries:$LD_LIBRARY_PATH" \
    scilab-cli-bin -nb -quit -f "$1" >scilab.log 2>&1 </dev/null || true
  sed -n 's/^seen //p' scilab.log
}

r() { # SCRIPT: its output, without a line on R's own settings, which are not unpacked; messages are in r.log
  local home="$root/usr/lib/R" share="$root/usr/share/R/share"
  [[ -x "$home/bin/exec/R" ]] || home=/usr/lib/R share=/usr/share/R/share
  EDITOR=vi PAGER=cat R_HOME="$home" R_SHARE_DIR="$share" \
    R_LIBS="$root/usr/lib/R/site-library:/usr/lib/R/site-library" LD_LIBRARY_PATH="$home/lib:$LD_LIBRARY_PATH" \
    "$home/bin/exec/R" --vanilla --no-echo -f "$1" 2>r.log </dev/null | sed '/^cannot find system Renviron/d' || true
}
