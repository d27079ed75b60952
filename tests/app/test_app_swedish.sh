#!/usr/bin/env bash
# In Swedish: words and numbers are those of the language, wherever the window shows any. Arguments:
# build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_swedish.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
export LANGUAGE=sv # as C.UTF-8 lets it, where no locale is installed
start_display 1000x700
window_size 900 640
start_app pool
await 'says("partiklar") and moment > 5'
key space
await 'says("pausad")'

# What has numbers: amount, time, a reading, a stopwatch, properties, a legend.
key m w p v
await 'says("Tryck  ") and not says("Tryck  –") and says("0,00 s") and shows("legend")'
await 'says("3 000 partiklar") and says("−9,81") and says("0,000001") and says("20 000")'
written='[w.text for x in windows for w in x.widgets if w.text and __import__("re").search(r"\d\.\d|\de[-+]?\d|(^|\s)-\d", w.text)]'
is "not $written" || fail "numbers that are not Swedish: $answer"
is 'style.comma' || fail 'the ruler of the picture has a decimal point'

# What is refused stays as it was typed, marked, with the reason below it, until something else is.
press Y Entry
await 'focused()'
for wrong in tre 1e9; do
    key ctrl+a
    xdotool type --delay 5 "$wrong"
    await "find('Y', 'Entry').text == '$wrong'"
    key Return
    await 'find("Y", "Entry").invalid and says("från −")'
    is "find('Y', 'Entry').text == '$wrong' and not message" || fail "what was typed is gone"
done
key ctrl+a
xdotool type --delay 5 ' -3,71'
await 'find("Y", "Entry").text == " -3,71"'
key Return
await 'not find("Y", "Entry").invalid and not says("från −")'
await 'find("Y", "Entry").text == "−3,71"'
quit_app
echo "swedish: words and numbers"
