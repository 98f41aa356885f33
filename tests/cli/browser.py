# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens a page of a report in Chromium at a width and measures what a reader would see."""

import html
import json
import pathlib
import re
import shutil
import subprocess
import tempfile

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")

# A window has a least width, a frame has none. Words of a drawing are clipped where they leave its <svg>; two words of one
# drawing overlap where their boxes share more than a few pixels in both directions.
FRAME = """<!DOCTYPE html><meta charset=utf-8><body style="margin:0"><iframe id=f src="{page}" width={width} height={height}
style="border:0"></iframe><pre id=found></pre><script>
const errors = [], f = document.getElementById("f");
window.addEventListener("error", e => errors.push(String(e.message)));
f.onload = () => {{
  const page = f.contentDocument, found = {{wide: page.documentElement.scrollWidth, clipped: [], over: [], errors}};
  const side = box => [box.left, box.top, box.right, box.bottom];
  for (const table of page.querySelectorAll(".answer")) {{
    const frame = table.closest(".wide");
    if (frame.scrollWidth > frame.clientWidth + 1) found.clipped.push("table of the answer: " + frame.scrollWidth);
  }}
  for (const svg of page.querySelectorAll("svg.plot")) {{
    const frame = svg.getBoundingClientRect();
    if (!frame.width || svg.parentElement.closest("svg")) continue;
    const words = [...svg.querySelectorAll("text")].map(t => [t.textContent, t.getBoundingClientRect()]);
    for (const [text, box] of words)
      if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1)
        found.clipped.push(text + " " + side(box).map(Math.round) + " in " + side(frame).map(Math.round));
    words.forEach(([a, one], k) => words.slice(k + 1).forEach(([b, other]) => {{
      const across = Math.min(one.right, other.right) - Math.max(one.left, other.left);
      const up = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
      if (across > 3 && up > 0.4 * Math.min(one.height, other.height)) found.over.push(a + " | " + b);
    }}));
  }}
  document.getElementById("found").textContent = JSON.stringify(found);
}};</script>"""


def _run(page, width, height, *options):
    with tempfile.TemporaryDirectory() as folder:
        frame = pathlib.Path(folder) / "frame.html"
        frame.write_text(FRAME.format(page=pathlib.Path(page).resolve().as_uri(), width=width, height=height), encoding="utf-8")
        return subprocess.run(
            [CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars",
             "--disable-web-security", "--allow-file-access-from-files", f"--user-data-dir={folder}/profile",
             "--virtual-time-budget=8000", f"--window-size={max(width, 520)},{height}", *options, frame.as_uri()],
            capture_output=True, text=True, timeout=120, check=True).stdout


def measured(page, width):
    """{"wide": width of its content in px, "clipped", "over": words, "errors"} of a page in a window of this width."""
    dom = _run(page, width, 2000, "--dump-dom")
    return json.loads(html.unescape(re.search(r'<pre id="found">(.*?)</pre>', dom, re.S)[1]))


def picture(page, width, height, path):
    """Writes what it looks like."""
    _run(page, width, height, f"--screenshot={path}")


if __name__ == "__main__":
    import sys
    for size in map(int, sys.argv[2:] or ("400", "1400")):
        print(size, json.dumps(measured(sys.argv[1], size), indent=1, ensure_ascii=False))
