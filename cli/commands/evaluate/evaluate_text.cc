// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_command.h"
#include "shell/words.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>

namespace fca::cli {

namespace {

/// A column of a table: its width, and what stands in its two lines of heading.
struct Column {
  std::size_t width = 0;
  std::string_view group;
  std::string_view name;
};

std::string heading(std::span<const Column> columns) {
  std::string groups = "  ";
  std::string names = "  ";
  for (const Column& column : columns) {
    groups += padded(column.group, column.width);
    names += padded(column.name, column.width);
  }
  const auto without_end = [](const std::string& line) { return line.substr(0, line.find_last_not_of(' ') + 1) + "\n"; };
  return without_end(groups) + without_end(names);
}

std::string line(std::span<const Column> columns, std::span<const std::string> cells) {
  std::string text = "  ";
  for (std::size_t i = 0; i < cells.size(); ++i) text += padded(cells[i], columns[i].width);
  return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

/// With all the digits that were published.
std::string as_published(double value) { return text::format_short(value, 7); }

/// The value, or a dash.
std::string or_dash(const std::optional<double>& value) { return value ? pixels(*value) : "-"; }

std::string name_of(const EvaluatedRow& row) {
  return std::string(row.published.from.name) + "-" + std::string(row.published.to.name);
}

std::string milliseconds(double microseconds) { return text::format_short(microseconds / 1000.0, 2); }

std::string field_of_view_in_words(const std::optional<double>& max_angle_deg) {
  return max_angle_deg ? "inside " + text::format_short(*max_angle_deg, 4) + " deg from the axis" : "the whole image";
}

/// Each reason once, after the rows it is for.
std::string reasons(const std::vector<EvaluatedRow>& rows) {
  std::string text;
  std::vector<std::string_view> said;
  for (const EvaluatedRow& row : rows) {
    if (std::ranges::find(said, row.published.why) != said.end()) continue;
    said.push_back(row.published.why);
    std::vector<std::string> names;
    for (const EvaluatedRow& other : rows) {
      if (other.published.why == row.published.why) names.push_back(name_of(other));
    }
    text += paragraph(enumerated(names) + ": " + std::string(row.published.why), "  ");
  }
  return text;
}

std::string table_text(const EvaluatedTable& table) {
  constexpr std::array<Column, 10> kColumns = {{{10, "", "in-out"},
                                                {10, "paper", "RE"},
                                                {9, "theirs", "mean px"},
                                                {9, "", "max px"},
                                                {10, "ours", "RE"},
                                                {10, "", "mean px"},
                                                {10, "", "rms px"},
                                                {10, "", "max px"},
                                                {10, "PE", "paper"},
                                                {10, "", "ours"}}};
  const paper::ConversionTable& published = table.published;
  std::string text = "Table " + std::to_string(published.number) + ": " + std::string(published.title) + ", " +
                     size_in_words(published.size) + " px, " + field_of_view_in_words(published.max_angle_deg) + "\n" +
                     heading(kColumns);
  std::vector<std::string> times;
  for (const EvaluatedRow& row : table.rows) {
    const std::optional<paper::ErrorFigures>& theirs = row.published.authors_over_image;
    const ErrorSummary& error = row.conversion.report.statistics.error;
    const std::array<std::string, kColumns.size()> cells = {name_of(row),
                                                            as_published(row.published.reprojection_error_px),
                                                            or_dash(theirs ? std::optional(theirs->mean_px) : std::nullopt),
                                                            or_dash(theirs ? std::optional(theirs->max_px) : std::nullopt),
                                                            pixels(row.on_samples.mean_px),
                                                            pixels(error.mean),
                                                            pixels(error.rms),
                                                            pixels(error.max),
                                                            as_published(row.published.parameter_error),
                                                            text::format_short(row.parameter_error, 4)};
    text += line(kColumns, cells);
    times.push_back(name_of(row) + " " + as_published(row.published.time_ms) + "/" + milliseconds(row.time_us));
  }
  text += "  time in ms, the paper's on its machine / ours on this one:\n" + wrapped(times, "    ");
  return text + reasons(table.rows) + paragraph(published.remark, "  ");
}

/// What an image loses: the paper's figures, the same by its program's way, and what is lost indeed.
std::string images_text(const EvaluatedTable& table) {
  constexpr std::array<Column, 9> kColumns = {{{10, "", "in-out"},
                                               {9, "paper", "PSNR dB"},
                                               {8, "", "SSIM"},
                                               {9, "painted", "PSNR dB"},
                                               {8, "", "SSIM"},
                                               {9, "ours", "PSNR dB"},
                                               {8, "", "SSIM"},
                                               {10, "", "compared"},
                                               {8, "models differ", "rms px"}}};
  if (table.rows.empty() || !table.rows.front().recovered) return "";
  std::string text = "  the image, recovered:\n" + heading(kColumns);
  for (const EvaluatedRow& row : table.rows) {
    const RecoveredImage& recovered = *row.recovered;
    text +=
        line(kColumns, std::array<std::string, kColumns.size()>{
                           name_of(row), as_published(row.published.psnr_db), as_published(row.published.ssim),
                           fixed(row.painted->psnr_db, 2), fixed(row.painted->ssim, 4),
                           std::isinf(recovered.psnr_db) ? "the same" : fixed(recovered.psnr_db, 2), fixed(recovered.ssim, 4),
                           percent(recovered.compared), pixels(row.conversion.report.statistics.error.rms)});
  }
  return text + "  painted without a conversion, but with noise of 1e-9 px: " + fixed(table.painted_noise->psnr_db, 2) +
         " dB, SSIM " + fixed(table.painted_noise->ssim, 4) + "\n";
}

std::string why_images_differ() {
  return paragraph(
             "Painted is what the paper's program does, with our fits: each pixel's colour becomes a disc of 5 pixels where "
             "the "
             "converted model has the pixel, cut to whole pixels. It takes the colour from that place too, not from where the "
             "pixel was, so that no displacement shows: only which of two neighbours' discs came last, which 1e-9 px decide. "
             "Identical images count as 0 dB. The paper's own columns are of its two images: give the image of a table to "
             "compare with that table.",
             "") +
         "\n" +
         paragraph(
             "Ours shows each ray's light where the converted model has its pixel. It looks every pixel up in the image where "
             "the source has its ray (Lanczos, at exactly that place, grey levels not rounded), and leaves out what lies "
             "within "
             "4 px of the border or is seen by one camera only. So it loses what the models differ by, and nothing else: equal "
             "models give the image itself.",
             "");
}

/// One block of Figure 2: a number per curve and point.
template <class Number>
std::string sweep_lines(const std::vector<SampleSweep>& sweeps, std::string_view indent, const Number& number_of) {
  constexpr std::size_t kName = 10;
  constexpr std::size_t kNumber = 9;
  const auto row = [indent](std::string text) {
    return std::string(indent) + text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  };
  std::string header = padded("in-out", kName);
  for (const SweepPoint& point : sweeps.front().points) header += padded(std::to_string(point.asked), kNumber);
  std::string text = row(header);
  for (const SampleSweep& sweep : sweeps) {
    std::string cells = padded(std::string(sweep.from.name) + "-" + std::string(sweep.to.name), kName);
    for (const SweepPoint& point : sweep.points) cells += padded(number_of(point), kNumber);
    text += row(cells);
  }
  return text;
}

std::string sweeps_text(const std::vector<SampleSweep>& sweeps) {
  if (sweeps.empty()) return "";
  const auto rms = [](const SweepPoint& point) { return pixels(point.rms_px); };
  const auto distance = [](const SweepPoint& point) { return text::format_short(point.parameter_error, 4); };
  const auto time = [](const SweepPoint& point) { return milliseconds(point.time_us); };
  return "Figure 2: the number of samples N, Table 1's conversions\n  PE by N\n" + sweep_lines(sweeps, "  ", distance) +
         "  rms px over the image by N\n" + sweep_lines(sweeps, "  ", rms) +
         "  time in ms by N, in this run on this machine:\n" + sweep_lines(sweeps, "    ", time) +
         paragraph(
             "The paper: PE no longer falls from N = 30 on, and the time grows from N = 1000 on. A fit here begins with N "
             "samples and doubles them up to three times where the error between them is another, so that few are enough; its "
             "default is 200. PE does not tell which N is enough, as it measures the distance to another calibration: the rms "
             "does.",
             "  ");
}

std::string polynomials_text(const EvaluatedPolynomials& polynomials) {
  constexpr std::array<Column, 9> kColumns = {{{26, "", "method"},
                                               {10, "", "a0"},
                                               {10, "", "a1"},
                                               {12, "", "a2"},
                                               {9, "", "RMSE"},
                                               {10, "inside", "deg"},
                                               {12, "", "without"},
                                               {10, "", "rms px"},
                                               {10, "", "max px"}}};
  const paper::Polynomial& toolbox = polynomials.published.toolbox;
  std::string text = "Table 3: " + std::string(polynomials.published.title) + " as OCamCalib's polynomial, " +
                     size_in_words(polynomials.published.size) + " px\n" + heading(kColumns) +
                     line(kColumns, std::array<std::string, 4>{"OCamCalib's calibration", as_published(toolbox.a0),
                                                               as_published(toolbox.a1), as_published(toolbox.a2)});
  std::vector<std::string> times;
  for (const EvaluatedPolynomial& row : polynomials.rows) {
    const Coverage& coverage = row.statistics.coverage;
    const double lens = coverage.scored + coverage.unrepresentable;
    text += line(kColumns,
                 std::array<std::string, kColumns.size()>{
                     row.method, text::format_short(row.polynomial.a0, 6), as_published(row.polynomial.a1),
                     text::format_short(row.polynomial.a2, 4), text::format_short(row.rmse, 4),
                     text::format_short(coverage.max_angle_deg, 4), percent(lens > 0.0 ? coverage.unrepresentable / lens : 0.0),
                     pixels(row.statistics.error.rms), pixels(row.statistics.error.max)});
    if (row.fit) times.push_back(milliseconds(row.time_us));
  }
  text += "  time of fca-io's fits in ms, in their order: " + enumerated(times) + "\n";
  return text + paragraph(sign_error_in_words(polynomials), "  ");
}

}  // namespace

std::string sign_error_in_words(const EvaluatedPolynomials& polynomials) {
  return "The sign of the paper's a2 is wrong. UCM's ray at r = gamma*m has the height a(r) = gamma*(1 - xi/k) with "
         "k = (xi + sqrt(1 + (1 - xi^2)*m^2)) / (1 + m^2), so that on the axis a2 = -xi/(2*gamma) = " +
         text::format_short(polynomials.sign.right_a2, 3) +
         ". The authors' program divides by 1 - m^2: then a2 = xi*(3 - xi)/(2*gamma*(1 + xi)) = " +
         text::format_short(polynomials.sign.wrong_a2, 3) +
         ", rays bend the wrong way, samples beyond r = gamma fall away, and a fit to the rest gives the paper's polynomial, "
         "which has no pixel for most rays (without) and wrong ones for the others. RMSE does not show it: a0 is nearly all of "
         "it. libPeR's a2 is printed with two digits, which alone leave some 3 px open at 90 deg: they are too few to "
         "evaluate its pixels. Degree 2 is short for this lens, so that a0 depends on how far it is to reach; degree 4 is "
         "enough.";
}

std::string replacement_in_words(const EvaluateResult& evaluation) {
  const paper::SlamCamera camera = paper::slam_camera();
  const ErrorSummary& error = evaluation.slam_camera.statistics.error;
  return "Not reproduced: Table 4 and Figure 4 run a SLAM system (fisheye ORB-SLAM) on two sequences of TUM VI, once with EUCM "
         "converted from KB and once with EUCM calibrated directly, and compare trajectories. The system's random samples hide "
         "errors of this size. The counterpart is examples/openvins_simulation of the source: OpenVINS' estimator, with "
         "converted calibrations, in simulated flights whose truth is known. That conversion itself, KB-EUCM of TUM VI's cam0, "
         "is off by " +
         pixels(error.rms) + " px rms over the " + text::format_short(camera.max_angle_deg, 4) +
         " deg of the lens, and nowhere by more than " + pixels(error.bound) +
         " px, which is proven (convert proves it for every file); and tests compare with separate calibrations of the same "
         "cameras.";
}

std::string evaluate_text(const EvaluateResult& evaluation) {
  std::string text =
      paragraph(
          "Lee, Fisheye-Calib-Adapter (2024), Tables 1-3 and Figures 2 and 3, recomputed. RE is the mean distance on the "
          "paper's samples (N = " +
              std::to_string(paper::kSamples) +
              "): the paper's after those that its program lost, ours with all of them. Mean, rms and max are over the "
              "image: theirs is the authors' program on every 4th pixel, ours is on every pixel. PE is the distance to "
              "another calibration's parameters.",
          "") +
      "\n";
  bool images = false;
  for (const EvaluatedTable& table : evaluation.conversions) {
    const std::string recovered = images_text(table);
    images = images || !recovered.empty();
    text += table_text(table) + recovered + "\n";
  }
  if (images) text += why_images_differ() + "\n";
  return text + polynomials_text(evaluation.polynomials) + "\n" + sweeps_text(evaluation.sweeps) + "\n" +
         paragraph(replacement_in_words(evaluation), "");
}

}  // namespace fca::cli
