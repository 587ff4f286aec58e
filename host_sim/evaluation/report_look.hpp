/// The style sheet and the script of the flight report.
#pragma once

namespace tedavis::host_sim {

/// Dark on light; one column on a phone; on paper every moment is shown.
inline constexpr char kReportStyle[] = R"css(
:root{color-scheme:light;--ink:#1b1f24;--soft:#57606a;--line:#d0d7de;--pale:#f6f8fa;--strong:#0b57a4}
*{box-sizing:border-box}
body{font:16px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif;color:var(--ink);background:#fff;
max-width:74rem;margin:0 auto;padding:1.25rem}
h1{font-size:1.5rem;line-height:1.25;margin:0 0 .3rem}
h2{font-size:1.15rem;margin:2rem 0 .5rem}
h3{font-size:1.05rem;margin:0}
p{margin:.3rem 0;max-width:52rem}
.soft,figcaption,dt{color:var(--soft)}
.soft{font-size:.9rem}
a{color:var(--strong)}
a:focus-visible,summary:focus-visible{outline:3px solid #f2a900;outline-offset:2px}
.facts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,11rem),1fr));gap:.75rem;margin:1rem 0}
.fact{background:var(--pale);border:1px solid var(--line);border-radius:.5rem;padding:.6rem .8rem}
.fact b{display:block;font-size:1.5rem;line-height:1.2;font-variant-numeric:tabular-nums}
.fact span{display:block;font-size:.85rem;color:var(--soft)}
.chart{display:block;width:100%;height:auto}
.chart text{font:12px system-ui,-apple-system,"DejaVu Sans",sans-serif;fill:var(--ink)}
.chart .span{font-size:10px;fill:#111}
.chart .grid{stroke:var(--line);stroke-width:1}
.narrow{display:none}
.mark line{stroke:#b3261e;stroke-width:1;stroke-dasharray:2 2}
.mark .place{fill:#b3261e}
.mark .label{fill:#fff;stroke:#b3261e;stroke-width:1.5}
.chart .mark text{font-weight:700;font-size:11px;fill:#b3261e}
.chart rect{stroke:#fff;stroke-width:1}
.mark{cursor:pointer}
.mark:hover .label,.mark.chosen .label{fill:#b3261e}
.chart .mark:hover text,.chart .mark.chosen text{fill:#fff}
.tabs{display:flex;flex-wrap:wrap;gap:.4rem;margin:.6rem 0;padding:0;list-style:none}
.tabs a{display:block;padding:.35rem .7rem;border:1px solid var(--line);border-radius:.5rem;text-decoration:none;color:var(--ink);
font-size:.9rem;line-height:1.3;font-variant-numeric:tabular-nums;background:#fff}
.tabs a b{color:#b3261e}
.tabs a.chosen{border-color:#b3261e;box-shadow:inset 0 0 0 1px #b3261e;background:#fff5f4}
.moment{border:1px solid var(--line);border-radius:.5rem;padding:.9rem;margin:.75rem 0;break-inside:avoid;scroll-margin-top:1rem}
.moment:target{border-color:#b3261e}
.js .moment{display:none}
.js .moment.shown{display:block}
.views{display:grid;grid-template-columns:repeat(5,1fr);gap:.6rem;margin:.7rem 0}
figure{margin:0}
figure img{display:block;width:100%;height:auto;border:1px solid var(--line)}
figcaption{font-size:.85rem;margin-top:.15rem}
.plan{display:grid;grid-template-columns:max-content 1fr;gap:.1rem .9rem;margin:.4rem 0 0;font-size:.9rem}
.plan dt,.plan dd{margin:0;overflow-wrap:anywhere}
.wide-table{overflow-x:auto}
table{border-collapse:collapse;font-size:.92rem;width:100%}
th,td{text-align:left;padding:.3rem .8rem .3rem 0;border-bottom:1px solid var(--line);vertical-align:top}
thead th{border-bottom:2px solid var(--ink);white-space:nowrap}
.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
tr.all th,tr.all td{border-top:2px solid var(--ink);font-weight:600}
.phase{white-space:nowrap}
.key{display:inline-block;width:.8rem;height:.8rem;margin-right:.4rem;border-radius:.15rem;vertical-align:-.05rem}
.bar{display:flex;width:100%;min-width:9rem;height:1.5rem;border:1px solid var(--line);overflow:hidden;font-size:.78rem;line-height:1.4rem}
.bar span{display:block;overflow:hidden;text-align:center;color:#111;white-space:nowrap}
.bar .first,.key.first{box-shadow:inset 0 0 0 2.5px #111}
.entry{white-space:nowrap;margin-right:.9rem}
td.first{font-weight:700}
.more{color:#b3261e}.less{color:#1a7f37}
.regions{width:auto;border-collapse:separate;border-spacing:2px}
.regions td{border:0;padding:.35rem .5rem;text-align:center;font-variant-numeric:tabular-nums;font-size:.85rem;border-radius:.2rem}
details{margin:.6rem 0}
summary{cursor:pointer;font-weight:600}
footer{margin-top:2rem;border-top:1px solid var(--line);padding-top:.6rem;font-size:.85rem;color:var(--soft)}
@media (max-width:46rem){
body{padding:.8rem}
h1{font-size:1.25rem}
.wide,.aside{display:none}.narrow{display:block}
th,td{padding-right:.5rem}
.views{grid-template-columns:1fr 1fr}
.facts{grid-template-columns:1fr 1fr;gap:.5rem}
.fact b{font-size:1.25rem}
.plan{grid-template-columns:1fr}.plan dd{margin-bottom:.35rem}
.regions td{padding:.25rem .2rem;font-size:.72rem}
}
@page{margin:12mm}
@media print{
body{max-width:none;padding:0;font-size:9pt;line-height:1.35}
h1{font-size:14pt}h2{font-size:11pt;margin:.9rem 0 .3rem}h3{font-size:10pt}
.wide{display:block}.aside{display:table-cell}.narrow,.tabs,details{display:none}
.facts{grid-template-columns:repeat(4,1fr);gap:.4rem;margin:.5rem 0}
.fact{padding:.3rem .5rem}.fact b{font-size:12pt}.fact span{font-size:8pt}
.js .moment{display:block}
.moment{padding:.5rem;margin:.4rem 0}
.views{grid-template-columns:repeat(5,1fr);gap:.4rem;margin:.3rem 0}
.plan{grid-template-columns:max-content 1fr;font-size:8pt;gap:0 .6rem}.plan dd{margin:0}
figcaption,.soft,table{font-size:8pt}
th,td{padding:.12rem .5rem .12rem 0}
h2,h3{break-after:avoid}tr{break-inside:avoid}
*{print-color-adjust:exact;-webkit-print-color-adjust:exact}
}
)css";

/// Shows one moment at a time, the one that was clicked; without scripts all are shown one below the other, and links lead to
/// them.
inline constexpr char kReportScript[] = R"js(
(function(){
"use strict";
var cards=Array.prototype.slice.call(document.querySelectorAll(".moment"));
var links=Array.prototype.slice.call(document.querySelectorAll("a[href^='#moment-']"));
if(cards.length===0)return;
function show(id,bring){
var card=document.getElementById(id);
if(cards.indexOf(card)<0)card=cards[0];
cards.forEach(function(one){one.classList.toggle("shown",one===card);});
links.forEach(function(link){
var chosen=link.getAttribute("href")==="#"+card.id;
link.classList.toggle("chosen",chosen);
if(chosen)link.setAttribute("aria-current","true");else link.removeAttribute("aria-current");
});
if(bring)card.scrollIntoView({block:"nearest"});
}
document.documentElement.classList.add("js");
window.addEventListener("hashchange",function(){show(location.hash.slice(1),true);});
show(location.hash.slice(1),false);
})();
)js";

}  // namespace tedavis::host_sim
