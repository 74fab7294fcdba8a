// SPDX-License-Identifier: BSD-3-Clause
#include "list_commands.h"

#include "ledger_text.h"
#include "options/lists.h"
#include "shell/json.h"
#include "shell/model_words.h"
#include "shell/option_hints.h"
#include "shell/recommendation.h"
#include "shell/verdict_text.h"
#include "shell/words.h"

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/text/numbers.h>
#include <fca/toolkit/format_name.h>
#include <fca/toolkit/models.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace fca::cli {

namespace {

std::vector<std::string> model_names(const Format& format, bool stock) {
  std::vector<std::string> names;
  for (const StoredModel& row : format.models) {
    // What is only kept next to a model of the list is none of its own.
    if (row.stock == stock && (stock || !find_model(row.model)->kept_only)) names.emplace_back(row.model);
  }
  return names;
}

ExitCode list_ledger(const ListArguments& arguments, Console& console) {
  const std::vector<LedgerRow> rows = ledger();
  console.out(arguments.json ? ledger_json(rows) : ledger_text(rows));
  return ExitCode::kGood;
}

/// Between two columns.
constexpr std::size_t kGap = 2;

/// Wide enough for every cell of a column.
std::size_t width_of(std::span<const std::string> cells, std::size_t least) {
  for (const std::string& cell : cells) least = std::max(least, cell.size() + kGap);
  return least;
}

/// A format and, in columns, its models.
std::string format_details(const Format& format) {
  std::vector<std::string> models;
  std::vector<std::string> names;
  for (const StoredModel& row : format.models) {
    models.emplace_back(row.model);
    names.push_back("as " + std::string(row.file_name));
  }
  constexpr std::size_t kModel = 11;
  constexpr std::size_t kName = 31;
  const std::size_t model_width = width_of(models, kModel);
  const std::size_t name_width = width_of(names, kName);
  std::string text;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const StoredModel& row = format.models[i];
    const std::string head = "    " + padded(models[i], model_width) + padded(names[i], name_width);
    const std::string readers = "read by " + std::string(row.read_by) + (row.stock ? "" : "; only with --model");
    text += head + in_columns(readers, head.size(), head.size()) + "\n";
  }
  return text;
}

/// A format, and further names of its files.
std::string format_lines(const Format& format) {
  constexpr std::size_t kId = 12;
  const auto line = [](std::string_view id, const std::string& what) {
    const std::string head = "  " + padded(id, kId);
    return head + in_columns(what, head.size(), head.size()) + "\n";
  };
  std::string text = line(format.id, std::string(format.title) + " (" + std::string(format.syntaxes) + ")" +
                                         (format.is_written() ? "" : ", read only"));
  for (const FormatName& name : further_names(format))
    text += line(name.id, std::string(name.title) + ", a layout of " + std::string(format.id));
  return text;
}

struct GroupTitle {
  FormatGroup group;
  std::string_view title;
};
constexpr std::array kGroups = {
    GroupTitle{FormatGroup::kCalibration, "Calibration"}, GroupTitle{FormatGroup::kSlam, "Odometry and SLAM"},
    GroupTitle{FormatGroup::kReconstruction, "Reconstruction"}, GroupTitle{FormatGroup::kDatasets, "Datasets"},
    GroupTitle{FormatGroup::kDevices, "Devices, from the factory"}};

std::string formats_text(bool with_models) {
  std::string text;
  for (const GroupTitle& group : kGroups) {
    text += (text.empty() ? "" : "\n") + std::string(group.title) + "\n";
    for (const Format& format : all_formats()) {
      if (format.group == group.group) text += format_lines(format) + (with_models ? format_details(format) : "");
    }
  }
  return text;
}

/// README's table of what is written, and what is read only.
std::string formats_markdown() {
  std::string text = "| format | what | syntax | cameras | models | models only forks read |\n|---|---|---|---|---|---|\n";
  for (const Format& format : written_formats()) {
    text += "| `" + std::string(format.id) + "` | " + std::string(format.title) + " | " + std::string(format.syntaxes) + " | " +
            (format.many_cameras ? "1..n" : "1") + " | " + enumerated(model_names(format, true), "and") + " | " +
            enumerated(model_names(format, false), "and") + " |\n";
  }
  std::vector<std::string> read_only;
  for (const Format& format : all_formats().subspan(written_formats().size()))
    read_only.push_back("`" + std::string(format.id) + "` (" + std::string(format.title) + ")");
  return read_only.empty() ? text : text + "\nRead only: " + enumerated(read_only, "and") + ".\n";
}

ExitCode list_formats(const ListArguments& arguments, Console& console) {
  if (arguments.ledger) return list_ledger(arguments, console);
  if (arguments.json) {
    Json json;
    json.object([&] {
      json.put("fca_io", FCA_VERSION);
      json.array("formats", all_formats(), [&](const Format& format) {
        json.object([&] {
          json.put("id", format.id);
          json.put("title", format.title);
          json.put("syntax", format.syntaxes);
          json.put("program", format.program);
          json.put("read_only", !format.is_written());
          json.put("many_cameras", format.many_cameras);
          json.put("extrinsics", format.extrinsics);
          json.put("imu", format.imu);
          json.put("image_size", format.image_size);
          json.array("models", format.models, [&](const StoredModel& row) {
            json.object([&] {
              json.put("model", row.model);
              json.put("file_name", row.file_name);
              json.put("stock", row.stock);
              json.put("read_by", row.read_by);
            });
          });
        });
      });
    });
    console.out(json.document());
    return ExitCode::kGood;
  }
  console.out(arguments.markdown ? formats_markdown() : formats_text(arguments.verbose));
  return ExitCode::kGood;
}

ExitCode list_models(const ListArguments& arguments, Console& console) {
  if (arguments.json) {
    Json json;
    json.object([&] {
      json.put("fca_io", FCA_VERSION);
      json.array("models", all_models(), [&](const ModelInfo& model) {
        json.object([&] {
          json.put("id", model.id);
          json.put("title", model.title);
          json.array("aliases", model.aliases, [&](std::string_view alias) { json.value(alias); });
          json.array("parameters", model.parameters, [&](const Parameter& p) {
            json.object([&] {
              json.put("name", p.name);
              json.put("unit", p.unit);
              json.put("lower", p.lower);
              json.put("upper", p.upper);
            });
          });
          json.put("names_elsewhere", std::span<const std::string>(names_elsewhere(model.id)));
        });
      });
    });
    console.out(json.document());
    return ExitCode::kGood;
  }
  for (const ModelInfo& model : all_models()) {
    std::string names;
    for (const Parameter& p : model.parameters) names += (names.empty() ? "" : " ") + std::string(p.name);
    constexpr std::size_t kId = 20;
    const std::string indent(kId, ' ');
    console.out(padded(model.id, kId) + std::string(model.title) + "\n" + indent + names + "\n");
    const std::vector<std::string> elsewhere = names_elsewhere(model.id);
    if (!elsewhere.empty()) console.out(indent + enumerated(elsewhere) + "\n");
  }
  return ExitCode::kGood;
}

std::string candidates_json(const std::string& file, const std::vector<ModelsResult::OfCamera>& cameras) {
  Json json;
  const auto put_candidate = [&json](const Candidate& candidate) {
    json.put("model", candidate.model->id);
    json.put("fits", candidate.conversion.has_value());
    if (!candidate.conversion) return;
    const ErrorStatistics& j = candidate.conversion->report.statistics;
    json.put("exact", candidate.conversion->report.exact);
    json.put("rms_px", j.error.rms);
    json.put("max_px", j.error.max);
    json.put("max_angle_deg", j.coverage.max_angle_deg);
    json.put("scored_to_deg", candidate.conversion->report.scored_to_deg);
    json.put("scored_share", j.coverage.scored);
    json.put("outside_lens_share", j.coverage.outside_lens);
    json.put("unrepresentable_share", j.coverage.unrepresentable);
    json.put("decisive_rms_px", candidate.decisive().rms);
    json.put("decisive_p99_px", candidate.decisive().p99);
    if (candidate.in_circle) json.put("decisive_with_max_angle_deg", candidate.in_circle->max_angle_deg);
    json.put("region", candidate.distance.is_wide ? "inscribed-circle" : "image");
    json.put("reaches_all", reaches_all(candidate));
    json.put("read_by", std::span<const std::string>(stored_by_in_words(candidate)));
  };
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.put("file", file);
    json.array("cameras", cameras, [&](const ModelsResult::OfCamera& of_camera) {
      json.object([&] {
        json.put("name", of_camera.camera.name);
        json.put("model", of_camera.camera.lens_id());
        const Candidate* best = recommended(of_camera.candidates, nullptr);
        best != nullptr ? json.put("recommended", best->model->id) : json.null("recommended");
        json.array("targets", of_camera.candidates,
                   [&](const Candidate& candidate) { json.object([&] { put_candidate(candidate); }); });
      });
    });
  });
  return json.document();
}

constexpr std::size_t kModelWidth = 11;
constexpr std::size_t kNumberWidth = 10;

std::string numbers(std::initializer_list<std::string> cells) {
  std::string text;
  for (const std::string& cell : cells) text += padded(cell, kNumberWidth);
  return text;
}

/// Of a wide lens both regions, the one that decides first.
std::string row_text(const Candidate& candidate, bool is_wide) {
  const ConversionReport& report = candidate.conversion->report;
  const ErrorSummary& error = report.statistics.error;
  const PixelDistance& circle = candidate.decisive();
  const bool is_less = !reaches_all(candidate);
  const std::string_view id = candidate.model->id;
  std::string text = "  " + padded(id, std::max(kModelWidth, id.size() + 1));
  if (report.exact) {
    text += is_wide ? numbers({"exact", "", "exact", ""}) : numbers({"exact", "", ""});
  } else if (is_wide) {
    // A fit to a part of the image has no figures for all of it.
    const bool is_whole = is_less || !report.angle_reduced;
    text += numbers({is_less ? "" : pixels(circle.rms), is_less ? "" : pixels(circle.p99), is_whole ? pixels(error.rms) : "",
                     is_whole ? pixels(error.max) : ""});
  } else {
    text += numbers({pixels(error.rms), pixels(error.p99), pixels(error.max)});
  }
  if (candidate.in_circle && !is_less)
    return text + "--max-angle " + text::format_short(candidate.in_circle->max_angle_deg) + "\n";
  const std::string to = text::format_short(report.scored_to_deg, 3) + " deg";
  return text + (is_less || report.angle_reduced ? "to " + to : "all") + "\n";
}

std::string candidates_text(const Camera& camera, const std::vector<Candidate>& candidates) {
  const bool is_wide = std::ranges::any_of(candidates, [](const Candidate& each) { return each.distance.is_wide; });
  std::string text =
      wrapped_line(camera.name + " (" + std::string(camera.lens_id()) + "): " + recommendation(candidates, nullptr));
  if (is_wide) text += "  " + padded("", kModelWidth) + padded("inscribed circle", 2 * kNumberWidth) + "whole image\n";
  text += "  " + padded("model", kModelWidth) +
          (is_wide ? numbers({"rms px", "99 % px", "rms px", "max px"}) : numbers({"rms px", "99 % px", "max px"})) +
          "reaches\n";
  bool is_less = false;
  for (const Candidate* candidate : ranked(candidates)) {
    if (!is_less && !reaches_all(*candidate)) text += "  not all of the lens:\n";
    is_less = !reaches_all(*candidate);
    text += row_text(*candidate, is_wide);
  }
  const auto is_of_circle = [](const Candidate& each) { return each.conversion && each.in_circle && reaches_all(each); };
  if (std::ranges::any_of(candidates, is_of_circle))
    text += "  --max-angle: fitted up to that angle only, wrong beyond; without it, to the whole image\n";
  for (const Candidate& candidate : candidates) {
    if (candidate.conversion) continue;
    const std::vector<Diagnostic>& why = candidate.diagnostics.entries();
    const std::string why_not = why.empty() ? "does not fit" : message_of(why.back(), with_options);
    text += "  " + in_columns(std::string(candidate.model->id) + ": " + why_not, 2, 4) + "\n";
  }
  return text;
}

/// `models FILE`: every model its cameras could be written as.
ExitCode compare_file(const ListArguments& arguments, Console& console) {
  const ModelsResult result = compare_models(arguments.inputs, console.files());
  if (result.status != Status::kDone) return console.refuse(exit_code(result.status), result.diagnostics);
  console.show(result.diagnostics);
  if (arguments.json) {
    console.out(candidates_json(arguments.inputs.files.front(), result.cameras));
    return ExitCode::kGood;
  }
  for (const auto& [camera, candidates] : result.cameras) console.say(candidates_text(camera, candidates));
  return ExitCode::kGood;
}

/// How a reader was checked, and when.
std::string check_words(const consumers::ReaderSource& source) {
  const std::string when(source.checked_on);
  switch (source.check) {
    case consumers::ReaderCheck::kRealProgram:
      return "checked with " + std::string(source.checked_with) + " in CI (since " + when + ")";
    case consumers::ReaderCheck::kBuiltOnce:
      return "checked with pixels of the program, built once (" + when + ")";
    case consumers::ReaderCheck::kFromSource:
      break;
  }
  return "checked with its source only (" + when + ")";
}

std::string_view check_id(consumers::ReaderCheck check) {
  switch (check) {
    case consumers::ReaderCheck::kRealProgram:
      return "real-program";
    case consumers::ReaderCheck::kBuiltOnce:
      return "built-once";
    case consumers::ReaderCheck::kFromSource:
      break;
  }
  return "from-source";
}

void put_source(Json& json, const consumers::ReaderSource& source) {
  const auto put_known = [&json](std::string_view key, std::string_view value) {
    value.empty() ? json.null(key) : json.put(key, value);
  };
  json.put("source", consumers::source_words(source));
  json.put("repository", source.repository);
  put_known("commit", source.commit);
  put_known("version", source.version);
  put_known("date", source.date);
  json.put("checked", check_id(source.check));
  put_known("checked_with", source.checked_with);
  json.put("checked_on", source.checked_on);
}

ExitCode list_programs(const ListArguments& arguments, Console& console) {
  if (arguments.json) {
    Json json;
    json.object([&] {
      json.put("fca_io", FCA_VERSION);
      json.array("programs", consumers::all_consumers(), [&](const consumers::Consumer& consumer) {
        json.object([&] {
          json.put("id", consumer.id);
          json.put("program", consumer.program);
          json.put("format", consumer.format);
          json.put("tolerance_px", consumer.tolerance_px);
          put_source(json, consumer.source);
        });
      });
    });
    console.out(json.document());
    return ExitCode::kGood;
  }
  constexpr std::size_t kId = 19;
  const std::string indent(kId, ' ');
  for (const consumers::Consumer& consumer : consumers::all_consumers()) {
    const auto line = [&](const std::string& words) { return indent + in_columns(words, kId, kId + kGap) + "\n"; };
    console.out(padded(consumer.id, kId) + std::string(consumer.program) + ", reads " + std::string(consumer.format) + "\n" +
                line("after " + consumers::source_words(consumer.source)) + line(check_words(consumer.source)));
  }
  return ExitCode::kGood;
}

ExitCode run_models(const ListArguments& arguments, Console& console) {
  return arguments.inputs.files.empty() ? list_models(arguments, console) : compare_file(arguments, console);
}

}  // namespace

void add_list_commands(Application& application) {
  application.add<ListArguments>("formats", "The formats, and which camera models each can hold", &add_formats_options,
                                 &list_formats);
  application.add<ListArguments>("models", "The camera models; with a FILE, how well each would describe its cameras",
                                 &add_models_options, &run_models);
  application.add<ListArguments>("programs", "The programs whose readers fca-io imitates to prove what it writes",
                                 &add_programs_options, &list_programs);
}

}  // namespace fca::cli
