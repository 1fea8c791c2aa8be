// The properties in the braces of a dart, a pleat or a buttonhole.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/evaluate/session.hpp"

namespace toile {

class DetailProperties {
 public:
  /// `owner` says whose they are: "dart"; `words` are those that stand among them without a value.
  DetailProperties(Session& session, const Module& module, const char* owner, std::vector<std::string> known,
                   std::vector<std::string> words = {})
      : session_(session), module_(module), owner_(owner), known_(std::move(known)), words_(std::move(words)) {}

  /// The property's name; nothing, with an error, when it is unknown or was given before.
  std::optional<std::string> name(const syntax::Property& property);
  void set(const std::string& name, std::optional<double> value);
  bool has(const std::string& name) const { return sizes_.contains(name); }
  /// Its value, or 0 when it is not given.
  double size(const std::string& name) const;
  /// Whether all that is given is sound, and those are given; what is missing is reported with `help`.
  bool complete(std::initializer_list<const char*> needed, Span span, const std::string& help);

 private:
  Session& session_;
  const Module& module_;
  const char* owner_;
  std::vector<std::string> known_, words_;
  std::map<std::string, std::optional<double>> sizes_;
  bool good_ = true;
  bool misspelt_ = false;  // a property: what seems to be missing may be meant by it
};

}  // namespace toile
