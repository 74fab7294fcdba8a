// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/diagnostics.h>

namespace fca {

Message in_words(std::string words) {
  if (words.empty()) return {};
  return {Code::kInWords, {std::move(words)}};
}

std::string id_of(const Message& message) { return std::string(info(message.code).id); }

std::string id_of(const Diagnostic& diagnostic) { return diagnostic.code.empty() ? id_of(diagnostic.facts) : diagnostic.code; }

void Diagnostics::add(Code code, std::vector<Argument> arguments, SourceRange where) {
  add(info(code).severity, code, std::move(arguments), std::move(where));
}

void Diagnostics::add(Severity severity, Code code, std::vector<Argument> arguments, SourceRange where) {
  add({severity, {}, {}, {}, std::move(where), {code, std::move(arguments)}});
}

}  // namespace fca
