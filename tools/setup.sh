# SPDX-License-Identifier: Apache-2.0
# What quickstart and test share: providing packages, running commands, finding the reference face. Sourced, never run.
# shellcheck shell=bash disable=SC1090

print_only=no  # yes: say what would be done, do nothing
install=yes    # no: never call apt

say() { printf '\n== %s\n' "$*"; }
warn() { printf '%s\n' "$@" >&2; }
fail() {
  warn "$@"
  exit 1
}

# run COMMAND...   shows the command, then carries it out (unless only printing)
run() {
  printf '+ %s\n' "$*"
  [[ $print_only == yes ]] || "$@"
}

# packages SECTION...   "package probe" lines of these sections of tools/packages.txt
packages() {
  awk -v wanted=" $* " '
    /^\[/ { section = substr($1, 2, length($1) - 2); next }
    NF && $1 !~ /^#/ && index(wanted, " " section " ") { print $1, $2 }' tools/packages.txt
}

# The system's name for people, and whether the package list was written for it.
os_release=${FACIES_OS_RELEASE:-/etc/os-release}
system_name() { (. "$os_release" 2>/dev/null && printf '%s' "${PRETTY_NAME:-}") || uname -sr; }
is_debian_12() {
  (. "$os_release" 2>/dev/null && [[ ${VERSION_CODENAME:-} == bookworm ]]) &&
    command -v dpkg-query >/dev/null && command -v apt-get >/dev/null
}

# Packages of these sections that Debian's package database does not know as installed.
missing_packages() {
  local name
  while read -r name _; do
    [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$name" 2>/dev/null) == installed ]] || printf '%s\n' "$name"
  done < <(packages "$@")
}

# has PROBE   whether something is there, on a system whose package names are unknown (packages.txt tells the forms)
has() {
  local what=${1#*:} folder
  case $1 in
    command:*) command -v "$what" >/dev/null ;;
    pkg:*) command -v pkg-config >/dev/null && pkg-config --exists "$what" ;;
    python:*) command -v python3 >/dev/null && python3 -c "import $what" 2>/dev/null ;;
    header:*)
      for folder in /usr/include /usr/local/include /opt/homebrew/include; do
        [[ -e $folder/$what ]] && return
      done
      return 1
      ;;
    *) true ;;
  esac
}

# provide SECTION...   everything of these sections is there afterwards, or the reader knows what is missing
provide() {
  if is_debian_12; then
    provide_on_debian "$@"
  else
    provide_elsewhere "$@"
  fi
}

provide_on_debian() {
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if [[ ${#missing[@]} -eq 0 ]]; then
    printf 'All packages are installed.\n'
    return
  fi
  local become_root=() by_hand="apt-get update && apt-get install --no-install-recommends ${missing[*]}"
  [[ $install == yes ]] || fail "Not installed, and --no-install was given: ${missing[*]}" "As root: $by_hand"
  if [[ $(id -u) != 0 ]]; then
    command -v sudo >/dev/null || fail "Not installed: ${missing[*]}" \
      "This needs an administrator (you are not root and there is no sudo). As root: $by_hand"
    become_root=(sudo)
  fi
  say "Installing ${#missing[@]} Debian packages"
  local apt=("${become_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
  run "${apt[@]}" update || warn "The package lists could not be refreshed; trying with those that are there."
  run "${apt[@]}" install --yes --no-install-recommends "${missing[@]}" ||
    fail "Installing failed. What is needed, for an administrator: $by_hand"
}

provide_elsewhere() {
  local name probe missing=()
  while read -r name probe; do
    has "$probe" || missing+=("  $(printf '%-22s %s' "$name" "(looked for ${probe/:/ })")")
  done < <(packages "$@")
  [[ ${#missing[@]} -eq 0 ]] && return
  fail "This is $(system_name). facies installs its packages on Debian 12 only; here they have to come from you." \
    "Not found, by Debian's names:" "${missing[@]}" "Install them, then start again."
}

# reference_face   prints the folder of the paper's face (the one with face/ in it); nothing where it is not at hand
reference_face() {
  local given=${FACIES_REFERENCE_FACE:-} beside=../shared/reference-face/upstream
  if [[ -n $given ]]; then
    [[ -d $given/face ]] || fail "FACIES_REFERENCE_FACE is $given, but there is no folder face in it." \
      "It should be the folder src/artisynth/models of a clone of artisynth_models."
    printf '%s' "$given"
  elif [[ -d $beside/face ]]; then
    printf '%s' "$beside"
  fi
}
