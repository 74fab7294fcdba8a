// SPDX-License-Identifier: BSD-3-Clause
#include "page.h"

#include "html.h"
#include "map_figure.h"
#include "sections.h"
#include "style.h"

namespace fca::cli {

std::string page_around(const std::string& title, const std::function<void(Html&)>& content) {
  Html html;
  html.element("html", {{"lang", "en"}}, [&] {
    html.element("head", {}, [&] {
      html.element_without_end("meta", {{"charset", "utf-8"}});
      html.element_without_end("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
      // A browser may neither fetch nor run anything, whatever the page holds.
      html.element_without_end("meta", {{"http-equiv", "Content-Security-Policy"},
                                        {"content", "default-src 'none'; style-src 'unsafe-inline'; img-src data:"}});
      html.element_without_end("meta", {{"name", "generator"}, {"content", "fca-io " FCA_VERSION}});
      // Browsers ask for an icon where a page names none.
      html.element_without_end("link", {{"rel", "icon"}, {"href", "data:,"}});
      html.element("title", {}, title + " - fca-io report");
      html.style(kStyle);
    });
    html.element("body", {}, [&] {
      put_colour_scale(html);
      html.element("main", {}, [&] { content(html); });
    });
  });
  return html.document();
}

std::string report_page(const ReportContents& contents) {
  return page_around(contents.title, [&contents](Html& html) {
    put_summary(html, contents);
    put_candidates(html, contents);
    put_camera_table(html, contents);
    put_cameras(html, contents);
    put_poses(html, contents);
    put_imus(html, contents);
    put_findings(html, contents);
    put_ledger(html, contents);
    put_sources(html, contents);
  });
}

}  // namespace fca::cli
