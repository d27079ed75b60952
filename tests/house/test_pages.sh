#!/usr/bin/env bash
# What the documentation names exists: the targets of links with their headings, files, functions,
# flags, scenes, experiments, parameters, and the pages and sections that comments cite. The notebook
# lists its pages, and the performance page shows the committed results.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_pages.sh BUILD SOURCE}")
python3 "$(dirname "$0")/pages.py" "$build" "${2:?usage: test_pages.sh BUILD SOURCE}"
