# SPDX-License-Identifier: BSD-3-Clause
"""What the figures have in common: colours that follow the reader's light or dark page, and axes."""
import math
import pathlib

STYLE = ("<style>.ink{stroke:#333;fill:#333}.line{stroke:#333;fill:none}.soft{stroke:#999;fill:none}.mark{stroke:#c33;fill:#c33}"
         ".part{stroke:#999}text{font:12px sans-serif;stroke:none;fill:#333}"
         "@media(prefers-color-scheme:dark){.ink{stroke:#ddd;fill:#ddd}.line{stroke:#ddd}.soft,.part{stroke:#777}text{fill:#ddd}}</style>")


def write(name, width, height, body):
    pathlib.Path(name).write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                                  f'height="{height}">\n{STYLE}\n' + "\n".join(body) + "\n</svg>\n")


class Axes:
    """A field of 540 x 230, `top` below the drawing's edge, with x and y linear or logarithmic, from (x[0], y[0]) to (x[1], y[1])."""
    LEFT, WIDTH, HEIGHT = 64, 540, 230

    def __init__(self, x, y, log=False, log_x=False, top=20):
        self.x, self.y, self.log, self.log_x, self.TOP, self.body = x, y, log, log_x, top, []

    def at(self, x, y):
        along_x, along_y = (math.log10 if log else float for log in (self.log_x, self.log))
        part = lambda scale, ends, value: (scale(value) - scale(ends[0])) / (scale(ends[1]) - scale(ends[0]))
        return (self.LEFT + self.WIDTH * part(along_x, self.x, x),
                self.TOP + self.HEIGHT * (1 - part(along_y, self.y, min(max(y, self.y[0]), self.y[1]))))

    def grid(self, xs, ys, x_unit, y_unit):
        for y in ys:
            _, py = self.at(self.x[0], y)
            self.body.append(f'<line class="soft" x1="{self.LEFT}" y1="{py:.1f}" x2="{self.LEFT + self.WIDTH}" y2="{py:.1f}" stroke-width="0.4"/>')
            self.body.append(f'<text x="4" y="{py + 4:.0f}">{y:g} {y_unit}</text>')
        for x in xs:
            px, _ = self.at(x, self.y[0])
            self.body.append(f'<text x="{px - 10:.0f}" y="{self.TOP + self.HEIGHT + 16}">{x:g} {x_unit}</text>')

    def curve(self, points, red=False, dashes="", words="", at=None):
        """`words` stand at `at`, in the axes' units."""
        points = list(points)
        line = " ".join("%.1f,%.1f" % self.at(x, y) for x, y in points)
        dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
        colour = ' style="stroke:#c33"' if red else ""
        self.body.append(f'<polyline class="line" points="{line}"{dashed}{colour}/>')
        if words:
            self.words(*at, words)

    def bar(self, x, low, high, red=False):
        (px, bottom), (_, top) = self.at(x, low), self.at(x, high)
        colour = ' style="stroke:#c33"' if red else ""
        self.body.append(f'<path class="line" d="M{px:.1f} {bottom:.1f}V{top:.1f}M{px - 3:.1f} {top:.1f}h6M{px - 3:.1f} {bottom:.1f}h6"{colour}/>')

    def heading(self, words):
        self.body.append(f'<text x="{self.LEFT}" y="{self.TOP - 12}">{words}</text>')

    def words(self, x, y, words):
        px, py = self.at(x, y)
        self.body.append(f'<text x="{px:.0f}" y="{py:.0f}">{words}</text>')

    def mark(self, x, y):
        px, py = self.at(x, y)
        self.body.append(f'<circle class="mark" cx="{px:.1f}" cy="{py:.1f}" r="4"/>')

    def write(self, name):
        write(name, 640, 290, self.body)
