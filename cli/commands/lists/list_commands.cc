// SPDX-License-Identifier: BSD-3-Clause
#include "list_commands.h"

#include "commands/show/show_command.h"
#include "options/subcommand.h"
#include "shell/json.h"
#include "shell/words.h"
#include "toolkit/ledger.h"
#include "toolkit/model_candidates.h"

#include <fca/convert/domain.h>

#include <algorithm>

#include <CLI/CLI.hpp>

namespace fca::cli {

namespace {

std::vector<std::string> model_names(const Format& format, bool stock) {
  std::vector<std::string> names;
  for (const StoredModel& row : format.models) {
    if (row.stock == stock) names.emplace_back(row.model);
  }
  return names;
}

ExitCode list_ledger(const ListArguments& arguments, Console& console) {
  if (arguments.json) {
    Json json;
    json.object([&] {
      json.put("fca_io", FCA_VERSION);
      json.array("ledger", ledger(), [&](const LedgerRow& row) {
        json.object([&] {
          json.put("from", row.from->id);
          json.put("to", row.to->id);
          json.put("exact", std::span<const std::string>(row.exact));
          json.put("fitted", std::span<const std::string>(row.fitted));
          json.put("dropped", std::span<const std::string>(row.dropped));
          json.put("defaulted", std::span<const std::string>(row.defaulted));
        });
      });
    });
    console.out(json.document());
    return ExitCode::kGood;
  }
  const auto cell = [](const std::vector<std::string>& words) {
    return words.empty() ? std::string("-") : enumerated(words, "and");
  };
  console.out("| from | to | exact | fitted | dropped, and said | defaulted, and said |\n|---|---|---|---|---|---|\n");
  for (const LedgerRow& row : ledger()) {
    console.out("| `" + std::string(row.from->id) + "` | `" + std::string(row.to->id) + "` | " + cell(row.exact) + " | " +
                cell(row.fitted) + " | " + cell(row.dropped) + " | " + cell(row.defaulted) + " |\n");
  }
  return ExitCode::kGood;
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
  if (arguments.markdown) {
    console.out("| format | what | syntax | cameras | models | models only forks read |\n|---|---|---|---|---|---|\n");
    for (const Format& format : all_formats()) {
      console.out("| `" + std::string(format.id) + "` | " + std::string(format.title) + " | " + std::string(format.syntaxes) +
                  " | " + (format.many_cameras ? "1..n" : "1") + " | " + enumerated(model_names(format, true), "and") + " | " +
                  enumerated(model_names(format, false), "and") + " |\n");
    }
    return ExitCode::kGood;
  }
  for (const Format& format : all_formats()) {
    console.out(padded(format.id, 12) + std::string(format.title) + " (" + std::string(format.syntaxes) + ")\n");
    for (const StoredModel& row : format.models) {
      console.out("  " + padded(row.model, 10) + padded("as " + std::string(row.file_name), 34) + "read by " +
                  std::string(row.read_by) + (row.stock ? "" : "; only with --model") + "\n");
    }
  }
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
    console.out(padded(model.id, 10) + std::string(model.title) + "\n          " + names + "\n");
    const std::vector<std::string> elsewhere = names_elsewhere(model.id);
    if (!elsewhere.empty()) console.out("          " + enumerated(elsewhere) + "\n");
  }
  return ExitCode::kGood;
}

std::string candidates_json(const std::string& file, const std::vector<Camera>& cameras, const ReadingOptions& reading) {
  Json json;
  const auto put_candidate = [&json](const Candidate& candidate) {
    json.put("model", candidate.model->id);
    json.put("fits", candidate.conversion.has_value());
    if (!candidate.conversion) return;
    const Judgement& j = candidate.conversion->report.judgement;
    json.put("exact", candidate.conversion->report.exact);
    json.put("rms_px", j.error.rms);
    json.put("max_px", j.error.max);
    json.put("max_angle_deg", j.coverage.max_angle_deg);
    json.put("scored_to_deg", candidate.conversion->report.scored_to_deg);
    json.put("scored_share", j.coverage.scored);
    json.put("outside_lens_share", j.coverage.outside_lens);
    json.put("unrepresentable_share", j.coverage.unrepresentable);
    json.put("read_by", std::span<const std::string>(candidate.stored_by));
  };
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.put("file", file);
    json.array("cameras", cameras, [&](const Camera& camera) {
      json.object([&] {
        json.put("name", camera.name);
        json.put("model", model_info(camera.model).id);
        json.array("targets", candidates(camera, max_angle_rad(reading)),
                   [&](const Candidate& candidate) { json.object([&] { put_candidate(candidate); }); });
      });
    });
  });
  return json.document();
}

std::string candidates_text(const Camera& camera, const std::vector<Candidate>& candidates) {
  constexpr std::size_t kModel = 10;
  constexpr std::size_t kError = 11;
  constexpr std::size_t kReach = 13;
  std::string text = camera.name + " (" + std::string(model_info(camera.model).id) + ") as\n  " + padded("model", kModel) +
                     padded("rms px", kError) + padded("max px", kError) + padded("scored", kModel) +
                     padded("unreachable", kReach) + "stored by\n";
  for (const Candidate& candidate : candidates) {
    text += "  " + padded(candidate.model->id, kModel);
    if (!candidate.conversion) {
      const std::vector<Diagnostic>& why = candidate.diagnostics.entries();
      text += why.empty() ? "does not fit\n" : why.back().message + "\n";
      continue;
    }
    const Judgement& j = candidate.conversion->report.judgement;
    text += padded(pixels(j.error.rms), kError) + padded(pixels(j.error.max), kError) +
            padded(percent(j.coverage.scored), kModel) + padded(percent(j.coverage.unrepresentable), kReach) +
            enumerated(candidate.stored_by) + "\n";
  }
  return text;
}

/// `models FILE`: every model its cameras could be written as.
ExitCode compare_models(const ListArguments& arguments, Console& console) {
  if (const std::optional<std::string> error = check(arguments.reading)) return console.refuse(ExitCode::kUsage, *error);
  Diagnostics diagnostics;
  const std::optional<Calibration> calibration = read_input(arguments.file, arguments.reading, console, diagnostics);
  if (!calibration) return console.refuse(worse(code_of(diagnostics), ExitCode::kBadInput), diagnostics);
  const std::vector<Camera>& cameras = calibration->rig.cameras;
  if (cameras.empty()) return console.refuse(ExitCode::kBadInput, arguments.file + " holds no camera");
  // What no model could mend is said once, not once per model.
  for (const Camera& camera : cameras) static_cast<void>(domain_of(camera, max_angle_rad(arguments.reading), diagnostics));
  if (diagnostics.has_errors()) return console.refuse(ExitCode::kBadInput, diagnostics);
  console.show(diagnostics);
  if (arguments.json) {
    console.out(candidates_json(arguments.file, cameras, arguments.reading));
    return ExitCode::kGood;
  }
  for (const Camera& camera : cameras)
    console.say(candidates_text(camera, candidates(camera, max_angle_rad(arguments.reading))));
  return ExitCode::kGood;
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
        });
      });
    });
    console.out(json.document());
    return ExitCode::kGood;
  }
  for (const consumers::Consumer& consumer : consumers::all_consumers()) {
    console.out(padded(consumer.id, 19) + std::string(consumer.program) + ", reads " + std::string(consumer.format) + "\n");
  }
  return ExitCode::kGood;
}

void add_formats_options(CLI::App& command, ListArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.add_flag("--markdown", arguments.markdown, "The table of the README");
  command.add_flag("--ledger", arguments.ledger, "For every pair of formats: what is exact, fitted, dropped and defaulted");
  command.footer("Example:\n  fca-io formats\n  fca-io formats --ledger\n");
  command.callback([&arguments, &run] { run = [&arguments](Console& console) { return list_formats(arguments, console); }; });
}

void add_models_options(CLI::App& command, ListArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command.add_option("FILE", arguments.file, "Calibration file");
  add_reading_options(command, arguments.reading);
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.footer("Example:\n  fca-io models camchain.yaml --max-angle 97.5\n");
  command.callback([&arguments, &run] {
    run = [&arguments](Console& console) {
      return arguments.file.empty() ? list_models(arguments, console) : compare_models(arguments, console);
    };
  });
}

void add_programs_options(CLI::App& command, ListArguments& arguments, std::function<ExitCode(Console&)>& run) {
  command.add_flag("--json", arguments.json, "One JSON document on standard output");
  command.footer("Example:\n  fca-io programs\n");
  command.callback([&arguments, &run] { run = [&arguments](Console& console) { return list_programs(arguments, console); }; });
}

}  // namespace

void add_list_commands(CLI::App& app, ListArguments& arguments, std::function<ExitCode(Console&)>& run) {
  add_subcommand(app, "formats", "The formats, and which camera models each can hold",
                 [&arguments, &run](CLI::App& command) { add_formats_options(command, arguments, run); });
  add_subcommand(app, "models", "The camera models; with a FILE, how well each would describe its cameras",
                 [&arguments, &run](CLI::App& command) { add_models_options(command, arguments, run); });
  add_subcommand(app, "programs", "The programs whose readers fca-io imitates to prove what it writes",
                 [&arguments, &run](CLI::App& command) { add_programs_options(command, arguments, run); });
}

}  // namespace fca::cli
