/**
 * ReportStyle: the style sheet of quality reports.
 */
#pragma once

namespace vfm
{

/// CSS. Texts have a contrast of at least 4.5 to 1; the page has one column of at most 60 em.
constexpr const char* ReportStyle = R"(* { box-sizing: border-box; }
body { margin: 0; background: #fff; color: #1b2733; font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 60em; margin: 0 auto; padding: 1em; overflow-wrap: anywhere; }
h1 { font-size: 1.7em; line-height: 1.25; margin: 0.3em 0 0.6em; }
h2 { font-size: 1.2em; margin: 1.8em 0 0.5em; border-bottom: 1px solid #c6d0da; }
p { margin: 0.5em 0; color: #45525f; max-width: 42em; }
dl { margin: 0; }
dd { margin: 0; }
dt { color: #45525f; }
.counts { display: grid; grid-template-columns: repeat(auto-fit, minmax(6.5em, 1fr)); gap: 0.6em; }
.counts div { padding: 0.5em 0.7em; background: #eef3f7; border-radius: 4px; }
.counts dt { font-size: 0.85em; }
.counts dd { font-size: 1.25em; font-weight: 600; font-variant-numeric: tabular-nums; }
.facts div { display: flex; flex-wrap: wrap; gap: 0 1em; padding: 0.15em 0; }
.facts dt { flex: 0 0 11em; }
.facts dd { flex: 1 1 14em; }
.warnings { margin: 0; padding: 0; list-style: none; }
.warnings li { margin: 0.4em 0; padding: 0.5em 0.8em; background: #fff3dc; color: #4d3200;
  border-left: 4px solid #b26a00; }
.scroll { overflow-x: auto; background: no-repeat local right / 2.5em 100%
    linear-gradient(to left, #fff 30%, #fff0), no-repeat right / 0.8em 100%
    linear-gradient(to left, #1b273340, #1b273300); } /* a shadow where columns are hidden */
table { border-collapse: collapse; font-variant-numeric: tabular-nums; overflow-wrap: normal; }
th, td { padding: 0.3em 0.7em; text-align: right; border-bottom: 1px solid #dde4ea; }
td { white-space: nowrap; }
thead th { vertical-align: bottom; background: #eef3f7; color: #1b2733; font-size: 0.9em; }
th.text, td.text { text-align: left; white-space: normal; min-width: 6.5em;
  overflow-wrap: anywhere; }
tbody th, tfoot th { font-weight: normal; }
th:first-child { position: sticky; left: 0; background: #fff; }
thead th:first-child { background: #eef3f7; }
tfoot th, tfoot td { border-top: 2px solid #8595a5; font-weight: 600; }
figure { margin: 0.5em 0; }
svg { display: block; width: 100%; max-width: 40em; height: auto; }
svg rect { fill: #2a6f97; }
svg .grid { stroke: #dde4ea; }
svg text { font: 11px system-ui, sans-serif; fill: #45525f; }
svg .title { fill: #1b2733; }
summary { cursor: pointer; padding: 0.4em 0; }
@media (max-width: 40em) {
  main { padding: 0.8em; }
  th, td { padding: 0.3em 0.45em; font-size: 0.9em; }
}
@media print { .scroll { overflow: visible; } }
)";

} // namespace vfm
