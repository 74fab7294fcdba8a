// SPDX-License-Identifier: BSD-3-Clause
#include "covariance.h"

#include "fields.h"
#include "text/words.h"

#include <fca/code.h>
#include <fca/convert/uncertainty.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace fca::covariance {

using text::Node;

namespace {

constexpr std::string_view kHead = "covariance";
constexpr std::size_t kBeforeNames = 3;  // covariance CAMERA MODEL

/// A line with its words.
struct Line {
  const Node* node = nullptr;
  std::vector<Node> words;
};

std::vector<Line> lines_of(const text::Document& document) {
  std::vector<Line> lines;
  for (const Node& node : document.root().items) {
    if (node.items.empty() || node.tag == text::kCommentTag) continue;
    Line line{&node, {}};
    for (const Node& item : node.items) std::ranges::move(fields::words_in(item, ",; \t"), std::back_inserter(line.words));
    if (!line.words.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

bool is_head(const Line& line) { return line.words.front().value == kHead; }

class TableReader {
 public:
  TableReader(const text::Document& document, Diagnostics& diagnostics)
      : document_(document), reader_(document, text::Dialect::kPyYaml, diagnostics) {}

  void read_into(Rig& rig) {
    const std::vector<Line> lines = lines_of(document_);
    for (std::size_t i = 0; i < lines.size();) {
      const std::size_t end = static_cast<std::size_t>(
          std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1, lines.end(), is_head) - lines.begin());
      std::optional<Uncertainty> camera = read_block(lines[i], std::span(lines).subspan(i + 1, end - i - 1));
      if (!camera) return;
      if (std::ranges::find(rig.uncertainties, camera->camera, &Uncertainty::camera) != rig.uncertainties.end()) {
        reader_.say(*lines[i].node, Code::kReportTwice, {camera->camera});
        return;
      }
      rig.extra_fields.push_back({camera->camera, "covariance of its parameters", document_.source().name});
      rig.uncertainties.push_back(*std::move(camera));
      i = end;
    }
  }

 private:
  std::optional<Uncertainty> read_block(const Line& head, std::span<const Line> rows) {
    if (head.words.size() <= kBeforeNames || !is_head(head)) {
      reader_.say(*head.node, Code::kReportLineUnknown,
                  {kHead, head.words.front().value, "covariance CAMERA MODEL and names of parameters"});
      return std::nullopt;
    }
    Uncertainty camera;
    camera.camera = reader_.name(head.words[1], kHead);
    camera.where = document_.range(*head.node);
    const ModelInfo* model = find_model(head.words[2].value);
    if (model == nullptr) {
      reader_.say(head.words[2], Code::kUnknownModel, {head.words[2].value});
      return std::nullopt;
    }
    camera.model = model->id;
    const std::span<const Node> names = std::span(head.words).subspan(kBeforeNames);
    const std::optional<std::vector<std::size_t>> places = places_of(names, *model);
    if (!places) return std::nullopt;
    if (rows.size() != names.size()) {
      reader_.say(*head.node, Code::kCovarianceRowsMissing, {camera.camera, rows.size(), names.size()});
      return std::nullopt;
    }
    const std::size_t count = model->parameters.size();
    camera.covariance.assign(count * count, 0.0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!read_row(camera.camera, rows[i], (*places)[i], *places, count, camera.covariance)) return std::nullopt;
    }
    return is_covariance(head, rows, *places, count, camera) ? std::optional(std::move(camera)) : std::nullopt;
  }

  std::optional<std::vector<std::size_t>> places_of(std::span<const Node> names, const ModelInfo& model) {
    std::vector<std::size_t> places;
    for (const Node& name : names) {
      const auto found = std::ranges::find(model.parameters, name.value, &Parameter::name);
      const auto place = static_cast<std::size_t>(found - model.parameters.begin());
      if (found == model.parameters.end()) {
        std::vector<std::string> known;
        for (const Parameter& parameter : model.parameters) known.emplace_back(parameter.name);
        reader_.say(name, Code::kCovarianceUnknownParameter, {name.value, model.id, known});
        return std::nullopt;
      }
      if (std::ranges::find(places, place) != places.end()) {
        reader_.say(name, Code::kReportTwice, {name.value});
        return std::nullopt;
      }
      places.push_back(place);
    }
    return places;
  }

  bool read_row(const std::string& camera, const Line& row, std::size_t place, std::span<const std::size_t> places,
                std::size_t count, std::vector<double>& matrix) {
    if (row.words.size() != places.size()) {
      reader_.say(*row.node, Code::kNumbersWanted, {camera + " covariance", row.words.size(), places.size()});
      return false;
    }
    for (std::size_t j = 0; j < places.size(); ++j) {
      const std::optional<double> value = reader_.real(row.words[j], camera + " covariance");
      if (!value) return false;
      matrix[place * count + places[j]] = *value;
    }
    return true;
  }

  /// Symmetric, with no combination of parameters whose variance is below 0. Fills in the standard deviations.
  bool is_covariance(const Line& head, std::span<const Line> rows, std::span<const std::size_t> places, std::size_t count,
                     Uncertainty& camera) {
    std::vector<double>& matrix = camera.covariance;
    camera.sigmas.assign(count, 0.0);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double variance = matrix[places[i] * count + places[i]];
      if (variance < 0.0) {
        reader_.say(rows[i].words[i], Code::kReportSigmaNegative, {camera.camera + " variance", variance});
        return false;
      }
      camera.sigmas[places[i]] = std::sqrt(variance);
    }
    constexpr double kRounding = 1e-6;
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        double& below = matrix[places[i] * count + places[j]];
        double& above = matrix[places[j] * count + places[i]];
        if (std::abs(below - above) > kRounding * camera.sigmas[places[i]] * camera.sigmas[places[j]]) {
          reader_.say(rows[i].words[j], Code::kCovarianceNotSymmetric, {i + 1, j + 1, below, above});
          return false;
        }
        below = above;
      }
    }
    const double least = least_variance(camera);
    if (least >= -kRounding) return true;
    reader_.say(*head.node, Code::kCovarianceImpossible, {camera.camera, least});
    return false;
  }

  const text::Document& document_;
  fields::Reader reader_;
};

}  // namespace

bool is_table(const text::Document& document) {
  if (document.syntax() != text::Syntax::kWords) return false;
  const std::vector<Line> lines = lines_of(document);
  return !lines.empty() && is_head(lines.front());
}

void read(const text::Document& document, Rig& rig, Diagnostics& diagnostics) {
  TableReader(document, diagnostics).read_into(rig);
}

}  // namespace fca::covariance
