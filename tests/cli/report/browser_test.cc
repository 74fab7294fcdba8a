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

/// Opens the page in a frame of that width (a window is never as narrow as a telephone). A script around the frame looks at it;
/// the page itself allows none.
LaidOut laid_out(const std::string& html, int width) {
  const TemporaryFolder folder;
  const std::string frame = folder.write("frame.html", R"(<!doctype html><body style="margin:0"><pre id="said"></pre>
    <iframe style="border:0;height:3000px;width:)" + std::to_string(width) +
                                                           "px\" srcdoc=\"" + quoted(html) + R"("></iframe><script>
    addEventListener('load', () => {
      const frame = document.querySelector('iframe');
      const page = frame.contentDocument;
      const wide = element => element.getBoundingClientRect().width > 200;
      const pictures = [...page.querySelectorAll('image')];
      const charts = [...page.querySelectorAll('svg.chart')];
      const words = [...page.querySelectorAll('svg.chart text')].map(text => text.getBoundingClientRect().height);
      const requests = frame.contentWindow.performance.getEntriesByType('resource').filter(
        entry => !entry.name.startsWith('data:'));
      const spills = [...page.querySelectorAll('table, figure, pre, svg.chart')].filter(
        element => element.getBoundingClientRect().right > element.parentElement.getBoundingClientRect().right + 1);
      document.getElementById('said').textContent = `width=${page.documentElement.scrollWidth} ` +
        `pictures=${pictures.filter(wide).length}/${pictures.length} ` +
        `charts=${charts.filter(chart => wide(chart) && chart.querySelector('path, image')).length}/${charts.length} ` +
        `least_word=${Math.floor(Math.min(...words))} requests=${requests.length} ` +
        `spills=${spills.length}.`;
    });</script></body>)");
  const std::string dom = folder / "dom";
  const std::string log = folder / "log";
  const std::string command = std::string("timeout 120 ") + browser() +
                              " --headless=new --no-sandbox --disable-gpu --disable-background-networking"
                              " --enable-logging=stderr --window-size=1500,3000 --user-data-dir=" +
                              (folder / "profile") + " --dump-dom file://" + frame + " >" + dom + " 2>" + log + " </dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(log);
  LaidOut result;
  const std::vector<std::string> said = all_between(read_file(dom), "<pre id=\"said\">", "</pre>");
  if (!said.empty()) result.said = said.front();
  std::istringstream lines(read_file(log));
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

  static void expect_good(const std::string& html, int expected_pictures) {
    const LaidOut page = laid_out(html, GetParam());
    EXPECT_LE(number_behind(page.said, "width"), GetParam()) << "it is wider than its window";
    const std::string all = std::to_string(expected_pictures);
    EXPECT_TRUE(contains(page.said, " pictures=" + all + "/" + all + " ")) << page.said;
    const int charts = static_cast<int>(count_of(html, "class=\"chart\""));
    EXPECT_TRUE(contains(page.said, " charts=" + std::to_string(charts) + "/" + std::to_string(charts) + " ")) << page.said;
    EXPECT_GE(number_behind(page.said, "least_word"), 9) << "px: words in pictures can be read";
    EXPECT_EQ(number_behind(page.said, "requests"), 0);
    EXPECT_EQ(number_behind(page.said, "spills"), 0) << "something is wider than the room it has";
    EXPECT_EQ(page.console, "");
  }
};

TEST_P(ReportInABrowser, AConversionFits) {
  expect_good(page({kTumvi, "--with", kImu, "--to", "orbslam3", "--model", "eucm"}), 2);
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

INSTANTIATE_TEST_SUITE_P(Widths, ReportInABrowser, testing::Values(400, 740, 1400));

// Were the test's questions no questions, it would find every page good.
TEST(ReportInABrowserItself, ATestSeesWhatIsWrong) {
  if (browser() == nullptr) GTEST_SKIP() << "Chromium is not installed (.ci/install-packages installs it)";
  const std::string html = page({kTumvi});
  const std::string wide = with_replaced(html, "<main>", "<main><div style='width:2000px'>wide</div>");
  EXPECT_GT(number_behind(laid_out(wide, 400).said, "width"), 400);
  const std::string curious = with_replaced(html, "<main>", "<main><img src='https://example.invalid/x.png'>");
  EXPECT_NE(laid_out(curious, 400).console, "") << "the page's policy refuses it";
}

}  // namespace
}  // namespace fca::test
