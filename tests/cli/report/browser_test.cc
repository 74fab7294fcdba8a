// SPDX-License-Identifier: BSD-3-Clause
// Pages in a real browser, Debian's Chromium, as wide as a telephone's screen, as paper, and as a desk's screen.
#include "pages.h"

#include <array>
#include <cstdlib>
#include <sstream>

namespace fca::test {
namespace {

const char* browser() {
  for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"}) {
    if (fs::exists(path)) return path;
  }
  return nullptr;
}

/// As an attribute's value.
std::string quoted(const std::string& html) {
  std::string result;
  for (const char c : html) result += c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

/// What a page is like once it is laid out.
struct LaidOut {
  std::string said;     ///< Of the page, "key=value" with blanks between.
  std::string console;  ///< What the browser complains of.
};

enum class Scheme { kLight, kDark };

/// Runs the browser without a window; what it prints to its standard output.
std::string run_browser(const TemporaryFolder& folder, const std::string& options, const std::string& file) {
  const std::string out = folder / "out";
  const std::string log = folder / "log";
  const std::string command = std::string("timeout 120 ") + browser() +
                              " --headless=new --no-sandbox --disable-gpu --disable-background-networking"
                              " --enable-logging=stderr --user-data-dir=" +
                              (folder / "profile") + " " + options + " file://" + file + " >" + out + " 2>" + log +
                              " </dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(log);
  return read_file(out);
}

std::string scheme_option(Scheme scheme) {
  return std::string("--blink-settings=preferredColorScheme=") + (scheme == Scheme::kDark ? "0" : "1");
}

/// What a frame's script asks of the page in it. Contrast is WCAG 2's, of each element's own words and what lies behind them;
/// words on a map have an outline of their own.
constexpr std::string_view kQuestions = R"(
    const luminance = ([r, g, b]) => {
      const linear = [r, g, b].map(c => c / 255).map(c => c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
      return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
    };
    const numbers = colour => (colour.match(/[\d.]+/g) || []).map(Number);
    const shows = colour => numbers(colour).length === 3 || numbers(colour)[3] > 0.5;
    const behind = (element, style) => {
      for (let e = element; e; e = e.parentElement) if (shows(style(e).backgroundColor)) return style(e).backgroundColor;
      return 'rgb(255, 255, 255)';
    };
    const contrast = (a, b) => {
      const [low, high] = [luminance(numbers(a)), luminance(numbers(b))].sort((x, y) => x - y);
      return (high + 0.05) / (low + 0.05);
    };
    const has_words = element => [...element.childNodes].some(node => node.nodeType === 3 && node.textContent.trim());
    const ask = (frame, copies) => {
      const page = frame.contentDocument;
      const style = element => frame.contentWindow.getComputedStyle(element);
      const wide = element => element.getBoundingClientRect().width > 200;
      const pictures = [...page.querySelectorAll('image')];
      const seen = pictures.map((picture, i) => copies[i].naturalWidth > 1 && wide(picture));
      const charts = [...page.querySelectorAll('svg.chart')];
      // A chart's units are scaled to its room.
      const size = text => {
        const chart = text.closest('svg.chart');
        return parseFloat(style(text).fontSize) * chart.getBoundingClientRect().width / chart.viewBox.baseVal.width;
      };
      const requests = frame.contentWindow.performance.getEntriesByType('resource').filter(e => !e.name.startsWith('data:'));
      const spills = [...page.querySelectorAll('table, figure, pre, svg.chart')].filter(
        element => element.getBoundingClientRect().right > element.parentElement.getBoundingClientRect().right + 1);
      const words = [...page.body.querySelectorAll('*')].filter(e => has_words(e) && !e.closest('.onmap') && e.getClientRects().length);
      const contrasts = words.map(e => contrast(e.closest('svg') ? style(e).fill : style(e).color, behind(e, style)));
      return `width=${page.documentElement.scrollWidth} pictures=${seen.filter(Boolean).length}/${pictures.length} ` +
        `charts=${charts.filter(chart => wide(chart) && chart.querySelector('path, image')).length}/${charts.length} ` +
        `least_word=${Math.floor(Math.min(...[...page.querySelectorAll('svg.chart text')].map(size)))} ` +
        `least_contrast=${Math.floor(100 * Math.min(...contrasts))} page_light=${Math.floor(100 * luminance(numbers(style(page.body).backgroundColor)))} ` +
        `requests=${requests.length} spills=${spills.length}.`;
    };)";

/// Opens the page in a frame of that width (a window is never as narrow as a telephone). A script around the frame looks at it;
/// the page itself allows none. Of its pictures there are copies next to the frame, which know whether they could be decoded.
LaidOut laid_out(const std::string& html, int width, Scheme scheme = Scheme::kLight) {
  const TemporaryFolder folder;
  std::string copies;
  for (const std::string& picture : all_between(html, "<image href=\"", "\""))
    copies += "<img style=\"position:absolute;left:-9999px\" src=\"" + picture + "\">";
  const std::string start = R"(<!doctype html><meta charset="utf-8"><meta name="color-scheme" content="light dark">
    <body style="margin:0"><pre id="said"></pre><iframe style="border:0;height:3000px;width:)";
  const std::string script = "<script>" + std::string(kQuestions) + R"(
    addEventListener('load', () => {
      document.getElementById('said').textContent = ask(document.querySelector('iframe'), document.querySelectorAll('img'));
    });</script></body>)";
  const std::string frame = folder.write(
      "frame.html", start + std::to_string(width) + "px\" srcdoc=\"" + quoted(html) + "\"></iframe>" + copies + script);
  const std::string dom = run_browser(folder, "--window-size=1500,3000 " + scheme_option(scheme) + " --dump-dom", frame);
  LaidOut result;
  const std::vector<std::string> said = all_between(dom, "<pre id=\"said\">", "</pre>");
  if (!said.empty()) result.said = said.front();
  std::istringstream lines(read_file(folder / "log"));
  for (std::string line; std::getline(lines, line);) {
    if (contains(line, "CONSOLE")) result.console += line + "\n";
  }
  return result;
}

int number_behind(const std::string& said, const std::string& key) {
  const std::size_t at = said.find(key + "=");
  EXPECT_NE(at, std::string::npos) << key << " in '" << said << "'";
  return at == std::string::npos ? -1 : std::stoi(said.substr(at + key.size() + 1));
}

class ReportInABrowser : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    if (browser() == nullptr) GTEST_SKIP() << "Chromium is not installed (.ci/install-packages installs it)";
  }

  static void expect_good(const std::string& html, int expected_pictures, Scheme scheme = Scheme::kLight) {
    const LaidOut page = laid_out(html, GetParam(), scheme);
    EXPECT_LE(number_behind(page.said, "width"), GetParam()) << "it is wider than its window";
    const std::string all = std::to_string(expected_pictures);
    EXPECT_TRUE(contains(page.said, " pictures=" + all + "/" + all + " ")) << page.said;
    const int charts = static_cast<int>(count_of(html, "class=\"chart\""));
    EXPECT_TRUE(contains(page.said, " charts=" + std::to_string(charts) + "/" + std::to_string(charts) + " ")) << page.said;
    EXPECT_GE(number_behind(page.said, "least_word"), 9) << "px: words in pictures can be read";
    EXPECT_GE(number_behind(page.said, "least_contrast"), 450) << "hundredths: WCAG's AA";
    EXPECT_EQ(number_behind(page.said, "page_light") < 50, scheme == Scheme::kDark);
    EXPECT_EQ(number_behind(page.said, "requests"), 0);
    EXPECT_EQ(number_behind(page.said, "spills"), 0) << "something is wider than the room it has";
    EXPECT_EQ(page.console, "");
  }
};

TEST_P(ReportInABrowser, AConversionFits) {
  expect_good(page({kTumvi, "--with", kImu, "--to", "orbslam3", "--model", "eucm"}), 2);
}

TEST_P(ReportInABrowser, IsReadInTheDark) {
  expect_good(page({kTumvi, "--with", kImu, "--to", "orbslam3", "--model", "eucm"}), 2, Scheme::kDark);
}

TEST_P(ReportInABrowser, AllModelsFit) { expect_good(page({kTumvi, "--model", "all"}), 2); }

TEST_P(ReportInABrowser, LongNamesFit) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write(std::string(150, 'x') + ".yaml", kEquidistant + "  rostopic: /" + std::string(500, 'y') + "\n");
  expect_good(page({file, "--to", "orbslam3"}), 1);
}

TEST_P(ReportInABrowser, AComparisonFits) {
  const TemporaryFolder folder;
  const std::string path = folder / "page.html";
  const std::string other = folder.write("other.yaml", with_replaced(read_file(kTumvi), "254.93", "257.93"));
  ASSERT_EQ(run_program({"compare", kTumvi, other, "--report", path}).code, 0);
  expect_good(read_file(path), 2);
}

INSTANTIATE_TEST_SUITE_P(Widths, ReportInABrowser, testing::Values(390, 740, 1280));

/// How many sheets a printer gets.
std::size_t sheets_of(const std::string& html) {
  const TemporaryFolder folder;
  const std::string paper = folder / "page.pdf";
  run_browser(folder, "--print-to-pdf=" + paper, folder.write("page.html", html));
  const std::string pdf = read_file(paper);
  EXPECT_TRUE(pdf.starts_with("%PDF"));
  return count_of(pdf, "/Type /Page\n");
}

// All of it, over several sheets: nothing is cut off after the first.
TEST(ReportOnPaper, HasAsManySheetsAsItTakes) {
  if (browser() == nullptr) GTEST_SKIP() << "Chromium is not installed (.ci/install-packages installs it)";
  const std::size_t of_one = sheets_of(page({kTumvi, "--camera", "cam0"}));
  EXPECT_GE(of_one, 2U);
  EXPECT_GT(sheets_of(page({kTumvi, "--with", kImu, "--to", "orbslam3", "--model", "eucm"})), of_one);
}

// Were the test's questions no questions, it would find every page good.
TEST(ReportInABrowserItself, ATestSeesWhatIsWrong) {
  if (browser() == nullptr) GTEST_SKIP() << "Chromium is not installed (.ci/install-packages installs it)";
  const std::string html = page({kTumvi});
  const auto said_of = [&](const std::string& what, const std::string& with) {
    return laid_out(with_replaced(html, what, with), 400).said;
  };
  EXPECT_GT(number_behind(said_of("<main>", "<main><div style='width:2000px'>wide</div>"), "width"), 400);
  EXPECT_LT(number_behind(said_of("<main>", "<main><p style='color:#aaaaaa'>pale</p>"), "least_contrast"), 450);
  EXPECT_LT(number_behind(said_of(".label, .onmap { font-size: 13px", ".label, .onmap { font-size: 9px"), "least_word"), 9);
  EXPECT_TRUE(contains(said_of("data:image/png;base64,iVBOR", "data:image/png;base64,iVBOX"), "pictures=1/2 "));
  EXPECT_EQ(sheets_of(with_replaced(html, "<main>", "<main style='height:100vh;overflow:hidden'>")), 1U);
  const std::string curious = with_replaced(html, "<main>", "<main><img src='https://example.invalid/x.png'>");
  EXPECT_NE(laid_out(curious, 400).console, "") << "the page's policy refuses it";
}

}  // namespace
}  // namespace fca::test
