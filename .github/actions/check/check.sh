# Checks the maps of $MAPS, one a line, with the options in $OPTIONS. Writes a SARIF log to $SARIF if that is not empty, and
# annotations to standard output. Runs in the bash 3.2 of macOS, too.
set -euo pipefail

arguments=()
while IFS= read -r map; do
  map=${map%$'\r'}
  if [ -n "$map" ]; then arguments+=("$map"); fi
done <<< "$MAPS"
# Options are words: the shell divides them.
# shellcheck disable=SC2206
arguments+=(${OPTIONS:-})

# The run with annotations decides how it ends.
if [ -n "${SARIF:-}" ]; then
  skycube check "${arguments[@]}" --format sarif --exit-zero > "$SARIF" || true
fi
skycube check "${arguments[@]}" --format github
