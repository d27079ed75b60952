#!/usr/bin/env bash
# In Swedish: words, numbers and the messages of the library are those of the language, wherever the window
# shows any. Arguments: build folder, source folder.
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
await 'says("1 000 partiklar") and says("−9,81") and says("0,000001") and says("20 000")'
written='[w.text for x in windows for w in x.widgets if w.text and __import__("re").search(r"\d\.\d|\de[-+]?\d|(^|\s)-\d", w.text)]'
is "not $written" || fail "numbers that are not Swedish: $answer"
is 'style.comma' || fail 'the ruler of the picture has a decimal point'

# What is refused stays as it was typed, marked, with the reason below it, until something else is.
click Y Entry
await 'any(one.focus and "Text" in one.type for one in widgets())'
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

# What the library says of files and links: a picture too large, one damaged, a wrong key, a body too small, a
# fluid that is none, a wrong number, a damaged link.
head='\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0' tail='\0\0\0\x28\x08\x02\0\0\0aaaa'
printf '%b' "$head\x23\x28$tail" >"$work/stor.png"
printf '%b' "$head\0\x28$tail" >"$work/skadad.png"
printf '{"gravty": {}, "water": []}\n' >"$work/nyckel.json"
printf '{"water": [{"shape": "box"}], "bodies": [{"shape": "circle", "x": 1, "y": 0.5, "radius": 0.001}]}\n' >"$work/kropp.json"
printf '{"fluids": [{"name": "oil"}], "water": [{"shape": "box", "fluid": "olie"}]}\n' >"$work/ord.json"
printf '{"world": {"width": 2},\n"gravity": {"y": "tung"}}\n' >"$work/tal.json"
while IFS='|' read -r opened said; do
    start_app "$opened"
    await "message.endswith('$said')"
    quit_app
done <<END
$work/stor.png|stor.png: bilden har 9 000 x 40 bildpunkter; tillåtet är 16 till 8 192 åt vardera hållet
$work/skadad.png|skadad.png: skadad PNG: en kontrollsumma är fel; spara den igen eller hämta ett annat exemplar
$work/nyckel.json|nyckel.json:1: gravty: okänt fält; menade du gravity?
$work/kropp.json|kropp.json:1: bodies[0]: dess form har 0,000003142 m²; det minsta är en partikels, 0,00143999 m²
$work/ord.json|ord.json:1: water[0].fluid: "olie" är ingen vätska i denna scen; tillåtet är någon av water, oil
$work/tal.json|tal.json:2: gravity.y: "tung" är inget tal; tillåtet är ett tal från −1 000 till 1 000 m/s²
skvalp:1.abc|länk: den är skadad eller avklippt; kopiera hela
END
# What is worth saying of a scene that opens.
printf '%s' '{"fluid": {"law": "clavet", "clavet_near_stiffness": 0.2}, "particles": 300, ' \
    '"water": [{"shape": "box", "y1": 0.3}]}' >"$work/spricker.json"
start_app "$work/spricker.json"
await 'says("med fluid.clavet_near_stiffness 0,2 sväller och spricker clavet-vätskan; 0,0")'
quit_app
echo "swedish: words, numbers, messages and notes"
