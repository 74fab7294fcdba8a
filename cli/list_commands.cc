// SPDX-License-Identifier: BSD-3-Clause
#include "list_commands.h"

#include "choose_model.h"
#include "json.h"
#include "show_command.h"
#include "words.h"

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

ExitCode list_formats(const ListArguments& arguments, Console& console) {
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

/// `models FILE`: every model this camera could be written as.
ExitCode compare_models(const ListArguments& arguments, Console& console) {
  if (const std::optional<std::string> error = check(arguments.reading)) {
    console.error(*error);
    return ExitCode::kUsage;
  }
  Diagnostics diagnostics;
  const std::optional<Calibration> calibration = read_input(arguments.file, arguments.reading, console, diagnostics);
  console.show(diagnostics);
  if (!calibration) return worse(code_of(diagnostics), ExitCode::kBadInput);
  if (calibration->rig.cameras.empty()) {
    console.error(arguments.file + " holds no camera");
    return ExitCode::kBadInput;
  }
  Json json;
  ExitCode code = ExitCode::kGood;
  const auto each_model = [&](const Camera& camera, const ModelInfo& model) {
    Diagnostics found;
    ConvertOptions options;
    options.model = model.id;
    options.max_angle_rad = max_angle_rad(arguments.reading);
    const std::optional<Conversion> conversion = convert(camera, options, found);
    if (!conversion) {
      code = worse(code, ExitCode::kBadInput);
      console.show(found);
      return;
    }
    const Judgement& j = conversion->report.judgement;
    if (arguments.json) {
      json.object([&] {
        json.put("model", model.id);
        json.put("exact", conversion->report.exact);
        json.put("rms_px", j.error.rms);
        json.put("max_px", j.error.max);
        json.put("max_angle_deg", j.coverage.max_angle_deg);
        json.put("scored_share", j.coverage.scored);
        json.put("outside_lens_share", j.coverage.outside_lens);
        json.put("unrepresentable_share", j.coverage.unrepresentable);
        json.put("read_by", std::span<const std::string>(names_elsewhere(model.id)));
      });
      return;
    }
    console.out("  " + padded(model.id, 10) + padded(pixels(j.error.rms), 11) + padded(pixels(j.error.max), 11) +
                padded(percent(j.coverage.scored), 10) + padded(percent(j.coverage.unrepresentable), 13) +
                enumerated(names_elsewhere(model.id)) + "\n");
  };
  if (arguments.json) {
    json.object([&] {
      json.put("fca_io", FCA_VERSION);
      json.put("file", arguments.file);
      json.array("cameras", calibration->rig.cameras, [&](const Camera& camera) {
        json.object([&] {
          json.put("name", camera.name);
          json.put("model", model_info(camera.model).id);
          json.array("targets", all_models(), [&](const ModelInfo& model) { each_model(camera, model); });
        });
      });
    });
    console.out(json.document());
    return code;
  }
  for (const Camera& camera : calibration->rig.cameras) {
    console.out(camera.name + " (" + std::string(model_info(camera.model).id) + ") as\n  " + padded("model", 10) +
                padded("rms px", 11) + padded("max px", 11) + padded("scored", 10) + padded("unreachable", 13) + "stored by\n");
    for (const ModelInfo& model : all_models()) each_model(camera, model);
  }
  return code;
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
    console.out(padded(consumer.id, 14) + std::string(consumer.program) + ", reads " + std::string(consumer.format) + "\n");
  }
  return ExitCode::kGood;
}

}  // namespace

void add_list_commands(CLI::App& app, ListArguments& arguments, std::function<ExitCode(Console&)>& run) {
  CLI::App& formats = *app.add_subcommand("formats", "The formats, and which camera models each can hold");
  formats.add_flag("--json", arguments.json, "One JSON document on standard output");
  formats.add_flag("--markdown", arguments.markdown, "The table of the README");
  formats.footer("Example:\n  fca-io formats\n");
  formats.callback([&] { run = [&arguments](Console& console) { return list_formats(arguments, console); }; });

  CLI::App& models = *app.add_subcommand("models", "The camera models; with a FILE, how well each would describe its cameras");
  models.add_option("FILE", arguments.file, "Calibration file");
  add_reading_options(models, arguments.reading);
  models.add_flag("--json", arguments.json, "One JSON document on standard output");
  models.footer("Example:\n  fca-io models camchain.yaml --max-angle 97.5\n");
  models.callback([&] {
    run = [&arguments](Console& console) {
      return arguments.file.empty() ? list_models(arguments, console) : compare_models(arguments, console);
    };
  });

  CLI::App& programs = *app.add_subcommand("programs", "The programs whose readers fca-io imitates to prove what it writes");
  programs.add_flag("--json", arguments.json, "One JSON document on standard output");
  programs.footer("Example:\n  fca-io programs\n");
  programs.callback([&] { run = [&arguments](Console& console) { return list_programs(arguments, console); }; });
}

}  // namespace fca::cli
