// SPDX-License-Identifier: BSD-3-Clause
#include "ledger_text.h"

#include "shell/json.h"
#include "shell/option_hints.h"
#include "shell/words.h"

#include <fca/formats/text/numbers.h>

namespace fca::cli {

namespace {

/// "k3 = 0", "alpha in [0, 1)"; beyond it "k3 != 0", "alpha not in [0, 1)".
std::string in_words(const ParameterRange& range, bool beyond) {
  const std::string name(range.parameter.name());
  if (range.lower == range.upper) return name + (beyond ? " != " : " = ") + text::format_short(range.lower);
  const std::string upper = text::format_short(range.upper);
  const bool up_to = text::parse_real(upper) == range.upper;  // else the last number below it
  return name + (beyond ? " not in [" : " in [") + text::format_short(range.lower) + ", " + upper + (up_to ? "]" : ")");
}

std::string within(std::span<const ParameterRange> ranges) {
  std::string text;
  for (const ParameterRange& range : ranges) text += (text.empty() ? "" : ", ") + in_words(range, false);
  return text;
}

std::string beyond(std::span<const ParameterRange> ranges) {
  std::string text;
  for (const ParameterRange& range : ranges) text += (text.empty() ? "" : " or ") + in_words(range, true);
  return text;
}

std::string with_brackets(std::string_view model, const std::string& condition) {
  return std::string(model) + (condition.empty() ? "" : " (" + condition + ")");
}

/// "kb4", "radtan (k3 = 0)", "radtan (as rational where k3 != 0)"
std::string exact_in_words(const LedgerModel& model) {
  if (model.as.empty()) return with_brackets(model.model, within(model.limits));
  const std::string where = model.limits.empty() ? "" : " where " + beyond(model.limits);
  return with_brackets(model.model, "as " + std::string(model.as) + where);
}

/// "kb4", "radtan (k3 != 0)"
std::string fitted_in_words(const LedgerModel& model) { return with_brackets(model.model, beyond(model.limits)); }

/// A row in words.
struct Cells {
  std::vector<std::string> exact;
  std::vector<std::string> fitted;
  std::vector<std::string> dropped;
  std::vector<std::string> defaulted;
};

Cells cells_of(const LedgerRow& row) {
  Cells cells{{}, {}, text::texts_of(row.dropped, with_options), text::texts_of(row.defaulted, with_options)};
  for (const LedgerModel& model : row.exact) cells.exact.push_back(exact_in_words(model));
  for (const LedgerModel& model : row.fitted) cells.fitted.push_back(fitted_in_words(model));
  return cells;
}

std::string cell(const std::vector<std::string>& words) { return words.empty() ? "-" : enumerated(words, "and"); }

}  // namespace

std::string ledger_text(std::span<const LedgerRow> rows) {
  std::string text =
      "| from | to | exact | fitted | dropped, with a message | defaulted, with a message |\n|---|---|---|---|---|---|\n";
  for (const LedgerRow& row : rows) {
    const Cells cells = cells_of(row);
    text += "| `" + std::string(row.from->id) + "` | `" + std::string(row.to->id) + "` | " + cell(cells.exact) + " | " +
            cell(cells.fitted) + " | " + cell(cells.dropped) + " | " + cell(cells.defaulted) + " |\n";
  }
  return text;
}

std::string ledger_json(std::span<const LedgerRow> rows) {
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.array("ledger", rows, [&](const LedgerRow& row) {
      const Cells cells = cells_of(row);
      json.object([&] {
        json.put("from", row.from->id);
        json.put("to", row.to->id);
        json.put("exact", std::span<const std::string>(cells.exact));
        json.put("fitted", std::span<const std::string>(cells.fitted));
        json.put("dropped", std::span<const std::string>(cells.dropped));
        json.put("defaulted", std::span<const std::string>(cells.defaulted));
      });
    });
  });
  return json.document();
}

}  // namespace fca::cli
