# shellcheck shell=sh disable=SC2034  # who includes this uses root
# What the scripts of this folder share, from the root of the tree: `. tests/check.sh`
#   ok; no WORDS          counts a check; what failed, and of whom, if $name says it
#   report                the sum; its status is the script's
#   $root, $scratch       where we are; a folder that goes in the end
passed=0 failed=0 root=$PWD
ok() { passed=$((passed + 1)); }
no() { failed=$((failed + 1)); echo "${0##*/}: FAILED: ${name:+$name: }$*"; }
report() { echo "${0##*/}: $passed passed, $failed failed"; [ "$failed" -eq 0 ]; }
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
