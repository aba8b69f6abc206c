# Checks the maps of $MAPS, one a line, with the options in $OPTIONS. Writes a SARIF log to $SARIF if that is not empty, and
# annotations to standard output. Runs in the bash 3.2 of macOS, too.
set -euo pipefail

arguments=()
while IFS= read -r map; do
  if [ -n "$map" ]; then arguments+=("$map"); fi
done <<< "$MAPS"
# Options are words: the shell divides them.
# shellcheck disable=SC2206
arguments+=(${OPTIONS:-})

if [ -n "${SARIF:-}" ]; then
  skycube check "${arguments[@]}" --format sarif --exit-zero > "$SARIF"
fi
skycube check "${arguments[@]}" --format github
