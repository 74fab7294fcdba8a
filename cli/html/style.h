// SPDX-License-Identifier: BSD-3-Clause
// The page's style sheet. Colours have names; the dark ones hold on screens only, so that paper stays white.
#pragma once

#include <string_view>

namespace fca::cli {

inline constexpr std::string_view kStyle = R"css(
:root {
  color-scheme: light dark;
  --page: #f6f7f9; --card: #ffffff; --text: #1c2127; --soft: #59636e; --line: #d5dae0; --grid: #e6e9ed;
  --source: #0b62c4; --target: #d1410c; --reference: #8b949e; --link: #0b62c4;
  --good: #1a7f37; --warning: #9a6700; --error: #c62828; --nolens: #e2e5e9; --code: #eef1f4;
  --x: #d1242f; --y: #1a7f37; --z: #0969da; --imu: #8250df;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --page: #0e1116; --card: #171b22; --text: #e4e8ee; --soft: #9aa5b1; --line: #39424e; --grid: #272e38;
    --source: #58a6ff; --target: #ff9052; --reference: #76818d; --link: #6cb2ff;
    --good: #4ac26b; --warning: #dfa92f; --error: #ff7b72; --nolens: #2b323c; --code: #10141a;
    --x: #ff6b6b; --y: #4ac26b; --z: #6cb2ff; --imu: #c297ff;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--text); font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; }
main { max-width: 1160px; margin: 0 auto; padding: 20px 20px 60px; overflow-wrap: anywhere; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 8px 0 4px; }
h2 { font-size: 1.2rem; margin: 36px 0 10px; padding-bottom: 4px; border-bottom: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 18px 0 6px; }
p { margin: 6px 0; max-width: 75em; }
ul { margin: 6px 0; padding-left: 1.3em; }
li { margin: 4px 0; }
.soft { color: var(--soft); }
.good { color: var(--good); }
.warning { color: var(--warning); }
.error { color: var(--error); }
.strong { font-weight: 600; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: 0.87em; background: var(--code); border-radius: 4px; }
code { padding: 1px 4px; }
pre { padding: 10px 12px; margin: 6px 0; white-space: pre-wrap; border: 1px solid var(--line); }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 14px 16px; margin: 10px 0; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 190px), 1fr)); gap: 12px; margin: 14px 0; }
.tile { background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 12px 16px; }
.tile .big { font-size: 1.3rem; font-weight: 600; line-height: 1.3; }
.verdict { border-left: 8px solid var(--good); }
.verdict.care { border-left-color: var(--warning); }
.verdict.stop { border-left-color: var(--error); }
.verdict .word { font-size: 1.6rem; font-weight: 700; line-height: 1.25; color: var(--good); }
.verdict.care .word { color: var(--warning); }
.verdict.stop .word { color: var(--error); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 400px), 1fr)); gap: 14px; align-items: start; }
figure { margin: 0; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 12px 14px; }
figcaption { font-weight: 600; margin-bottom: 8px; }
.chart { display: block; width: 100%; max-width: 640px; height: auto; margin: 0 auto; overflow: visible; }
.unseen { position: absolute; }
.label, .onmap { font-size: 13px; fill: var(--soft); }
.strong.label { fill: var(--text); }
.halo { paint-order: stroke; stroke: var(--card); stroke-width: 4px; stroke-linejoin: round; }
.grid { stroke: var(--grid); stroke-width: 1; }
.frame { stroke: var(--soft); stroke-width: 1; fill: none; }
.bar { stroke: var(--soft); stroke-width: 1; fill: url(#viridis); }
.mark { stroke: var(--soft); stroke-width: 1; stroke-dasharray: 2 3; }
.curve { fill: none; stroke-width: 2.2; stroke-linejoin: round; stroke: var(--source); }
.curve.source { stroke: var(--source); stroke-width: 5; opacity: 0.45; }
.curve.target { stroke: var(--target); stroke-width: 1.8; }
.curve.alone { stroke: var(--source); }
.curve.max { stroke: var(--target); stroke-width: 5; opacity: 0.5; }
.curve.rms { stroke: var(--source); stroke-width: 1.8; }
.curve.rotated { stroke: var(--good); stroke-width: 1.8; stroke-dasharray: 8 3; }
.curve.reference { stroke: var(--reference); stroke-width: 1.3; stroke-dasharray: 6 4; }
.curve.reference.dotted { stroke-dasharray: 2 3; }
.curve.c0 { stroke: #3b82f6; } .curve.c1 { stroke: #f97316; } .curve.c2 { stroke: #16a34a; } .curve.c3 { stroke: #e11d48; }
.curve.c4 { stroke: #8b5cf6; } .curve.c5 { stroke: #0891b2; } .curve.c6 { stroke: #b45309; } .curve.c7 { stroke: #db2777; }
.curve.c8 { stroke: #65a30d; } .curve.c9 { stroke: #64748b; } .curve.c10 { stroke: #a16207; }
.curve.c5, .curve.c6, .curve.c7, .curve.c8, .curve.c9, .curve.c10 { stroke-dasharray: 7 3; }
.thumbnail { display: block; width: 100%; max-width: 240px; height: auto; margin: 0 auto; }
.lattice { fill: none; stroke-width: 1; }
.lattice.before { stroke: var(--reference); opacity: 0.7; }
.lattice.after { stroke: var(--target); stroke-width: 1.3; }
.picture { image-rendering: auto; }
.nolens { fill: var(--nolens); }
.contour { fill: none; stroke: #ffffff; stroke-opacity: 0.75; stroke-width: 1; }
.onmap { fill: #ffffff; font-weight: 600; paint-order: stroke; stroke: #000000; stroke-opacity: 0.75; stroke-width: 3px; stroke-linejoin: round; }
.ring { fill: none; stroke: #ffffff; stroke-width: 2; }
.ring.back { stroke: #000000; stroke-width: 4.5; }
.rim { fill: none; stroke: #ffffff; stroke-width: 1.6; stroke-dasharray: 7 5; }
.rim.back { stroke: #000000; stroke-width: 3; stroke-opacity: 0.6; stroke-dasharray: none; }
.axis { fill: none; stroke-width: 2.4; stroke-linecap: round; }
.axis.x { stroke: var(--x); } .axis.y { stroke: var(--y); } .axis.z { stroke: var(--z); }
.body { fill: none; stroke: var(--soft); stroke-width: 1.2; stroke-linejoin: round; }
.origin { fill: var(--text); }
.imu { fill: none; stroke: var(--imu); stroke-width: 2.4; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 16px; margin-top: 8px; font-size: 0.85rem; color: var(--soft); }
.entry { display: inline-flex; align-items: center; gap: 6px; }
.sample { width: 30px; height: 10px; flex: none; }
.patch { width: 16px; height: 12px; border: 1px solid var(--soft); flex: none; }
.patch.outside { background: var(--nolens); }
.patch.unrepresentable { background: repeating-linear-gradient(135deg, #d83a56 0 3px, #ffe3e6 3px 7px); }
.patch.worst { border: 2.5px solid var(--soft); border-radius: 50%; width: 13px; height: 13px; }
.patch.rim { border: 2px dashed var(--soft); border-radius: 50%; width: 13px; height: 13px; }
.patch.cross { border: none; width: 12px; height: 12px; background:
  linear-gradient(var(--soft), var(--soft)) center / 12px 2px no-repeat, linear-gradient(var(--soft), var(--soft)) center / 2px 12px no-repeat; }
table { border-collapse: collapse; width: 100%; background: var(--card); border: 1px solid var(--line); margin: 10px 0; font-size: 0.92rem; }
th, td { padding: 5px 10px; text-align: left; border-bottom: 1px solid var(--grid); vertical-align: top; font-variant-numeric: tabular-nums; }
th { color: var(--soft); font-weight: 600; border-bottom: 1px solid var(--line); }
table.numbers th:not(:first-child), table.numbers td:not(:first-child) { text-align: right; }
td:first-child { font-weight: 600; }
td.short { white-space: nowrap; }
th { overflow-wrap: normal; vertical-align: bottom; }
figure table { border: none; margin: 0; }
figure th, figure td { padding: 3px 6px; }
.stack { display: grid; grid-template-columns: minmax(0, 1fr); gap: 14px; }
.candidates figure { max-width: 640px; }
details { margin: 10px 0; }
summary { cursor: pointer; color: var(--link); }
.finding { border-left: 4px solid var(--line); padding: 2px 0 2px 12px; margin: 12px 0; }
.finding.error { border-color: var(--error); color: inherit; }
.finding.warning { border-color: var(--warning); color: inherit; }
@media screen and (max-width: 860px) {
  main { padding: 12px 12px 40px; }
  figure { padding: 10px 8px; overflow-x: auto; }
  .numbers { font-size: 0.8rem; }
  .numbers th, .numbers td { padding: 3px; }
  table.cards, .cards tbody, .cards tr, .cards td { display: block; }
  .cards thead { display: none; }
  .cards tr { padding: 8px 0; border-bottom: 1px solid var(--line); }
  .cards td { display: flex; gap: 10px; justify-content: space-between; border: none; padding: 2px 12px; text-align: right; }
  .cards td::before { content: attr(data-title); color: var(--soft); font-weight: 400; text-align: left; flex: none; max-width: 45%; }
  .cards td:empty { display: none; }
}
@media print {
  body { background: #ffffff; font-size: 10pt; }
  main { max-width: none; padding: 0; }
  table { font-size: 8pt; }
  th, td { padding: 2px 5px; }
  figure, tr, .tile, .finding { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  .figures { grid-template-columns: 1fr 1fr; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

}  // namespace fca::cli
