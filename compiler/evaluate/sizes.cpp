#include "compiler/evaluate/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/call.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/measurements.hpp"
#include "compiler/evaluate/names.hpp"

namespace toile {
namespace {

// What a table's value has beside its measures.
constexpr const char* name_field = "size";
constexpr const char* all_field = "all";
// What `--size` means by it.
constexpr const char* every_size = "all";

/// One size's measurements.
struct SizeMeasures {
  std::string name;
  Location at;
  std::vector<RecordValue::Field> fields;
};

class SizesReader {
 public:
  SizesReader(Session& session, const Scope& scope, const syntax::Sizes& written)
      : session_(session),
        scope_(scope),
        module_(scope.module()),
        written_(written),
        table_(session.name_of(module_, written.name())) {}

  Value read() {
    const auto parameters = written_.measures();
    if (!parameters || !written_.name()) return Unknown{};
    check_names(*parameters);
    for (const syntax::View item : syntax::items(written_)) {
      if (const auto row = syntax::as<syntax::SizeRow>(item)) read_row(*row, *parameters);
    }
    enter_names();
    if (rows_.empty() && sound_) {
      refuse(*written_.name(), fmt::format("size table `{}` has no rows", table_), "a row a size: M 68cm, 94cm");
    }
    if (!sound_) return Unknown{};
    const SizeMeasures* row = chosen();
    return row == nullptr ? Value{} : value(*row);
  }

 private:
  /// `--size` asks for a row of the tables that are read: of a module's, those that the script uses.
  void enter_names() {
    std::vector<std::string> names;
    for (const syntax::View item : syntax::items(written_)) {
      if (const auto row = syntax::as<syntax::SizeRow>(item)) names.push_back(name_of(*row));
    }
    session_.size_tables.push_back(std::move(names));
  }

  void refuse(const syntax::View& at, const std::string& message, const std::string& help = "") {
    sound_ = false;
    if (!module_.broken(written_.span())) session_.report.add(Problem("E0119", message).at(module_.at(at)).help(help));
  }

  void check_names(const syntax::Parameters& measures) {
    for (const syntax::Parameter& measure : measures.list()) {
      const std::string name = session_.name_of(module_, measure.name());
      if (name != name_field && name != all_field) continue;
      refuse(measure, fmt::format("`{}` cannot be a measure: `{}.{}` is something else", name, table_, name),
             "choose another name for it");
    }
  }

  /// A row is like a call: its values are arguments, and a measure that is left out has its default.
  void read_row(const syntax::SizeRow& row, const syntax::Parameters& parameters) {
    if (!row.name() || !is_new_size(row)) return;
    const std::vector<syntax::Parameter> measures = parameters.list();
    const std::vector<syntax::Expr> values = row.values();
    const bool fits = values.size() <= measures.size() &&
                      (values.size() == measures.size() || measures[values.size()].fallback().has_value());
    if (!fits) {
      return refuse(row,
                    fmt::format("size `{}` has {} of the {} measures of `{}`", name_of(row), values.size(),
                                measures.size(), table_),
                    fmt::format("the measures are {}", session_.text(module_, parameters)));
    }
    std::vector<std::optional<Given>> given(measures.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      given[i] = Given{evaluate(session_, scope_, values[i]), module_.at(values[i])};
    }
    Scope inside(scope_.module(), &scope_, true);
    define_parameters(session_, inside, parameters, given);
    SizeMeasures read{name_of(row), module_.at(*row.name()), {}};
    for (const auto& definition : inside.definitions()) {
      read.fields.push_back({definition->name, force(session_, *definition)});
    }
    add(row, std::move(read));
  }

  bool is_new_size(const syntax::SizeRow& row) {
    const std::string name = name_of(row);
    if (name == every_size) {
      refuse(*row.name(), "no size is called `all`: `--size all` makes every size", "choose another name for it");
      return false;
    }
    const auto earlier = std::ranges::find(rows_, name, &SizeMeasures::name);
    if (earlier == rows_.end()) return true;
    session_.report.add(Problem("E0404", "size `" + name + "` is given twice")
                            .at(module_.at(*row.name()), "again here")
                            .also(earlier->at, "first here"));
    sound_ = false;
    return false;
  }

  /// Takes the row among the others if its values are of their kinds.
  void add(const syntax::SizeRow& row, SizeMeasures read) {
    const std::vector<syntax::Expr> values = row.values();
    for (std::size_t i = 0; i < read.fields.size(); ++i) {
      const auto& [name, value] = read.fields[i];
      if (value.unknown()) sound_ = false;
      if (rows_.empty() || value.unknown() || i >= rows_.front().fields.size()) continue;
      const SizeMeasures& first = rows_.front();
      if (alike(value, first.fields[i].value)) continue;
      refuse(i < values.size() ? syntax::View(values[i]) : syntax::View(row),
             fmt::format("`{}` of size `{}` is {}, and of size `{}` {}", name, read.name, describe(value), first.name,
                         describe(first.fields[i].value)));
    }
    std::vector<Measured> measured;
    for (std::size_t i = 0; i < read.fields.size(); ++i) {
      const syntax::View& at = i < values.size() ? syntax::View(values[i]) : syntax::View(row);
      measured.push_back({read.fields[i].name, read.fields[i].value, module_.at(at)});
    }
    sound_ = check_measurements(session_, fmt::format("size `{}`", read.name), measured) && sound_;
    rows_.push_back(std::move(read));
  }

  /// The row that was asked for, else the one after `at`, else the first.
  const SizeMeasures* chosen() {
    const auto base = written_.base();
    if (base && row_called(session_.name_of(module_, base)) == nullptr) {
      return unknown_size(session_.name_of(module_, base), *base);
    }
    if (!session_.size.empty()) {
      const SizeMeasures* row = row_called(session_.size);
      return row != nullptr ? row : unknown_size(session_.size, *written_.name());
    }
    return base ? row_called(session_.name_of(module_, base)) : &rows_.front();
  }

  const SizeMeasures* row_called(const std::string& name) const {
    const auto found = std::ranges::find(rows_, name, &SizeMeasures::name);
    return found == rows_.end() ? nullptr : &*found;
  }

  const SizeMeasures* unknown_size(const std::string& name, const syntax::View& at) {
    std::vector<std::string> known;
    for (const SizeMeasures& row : rows_) known.push_back(row.name);
    session_.report.add(Problem("E0118", fmt::format("`{}` has no size `{}`", table_, name))
                            .at(module_.at(at), fmt::format("its sizes are {}", fmt::join(known, ", ")))
                            .help(suggestion(name, known)));
    return nullptr;
  }

  static Value record_of(const SizeMeasures& row, std::vector<RecordValue::Field> more = {}) {
    std::vector<RecordValue::Field> fields{{name_field, Text{row.name}}};
    fields.insert(fields.end(), row.fields.begin(), row.fields.end());
    fields.insert(fields.end(), more.begin(), more.end());
    return record_value(std::move(fields));
  }

  Value value(const SizeMeasures& chosen) const {
    std::vector<Value> all;
    for (const SizeMeasures& row : rows_) all.push_back(record_of(row));
    return record_of(chosen, {{all_field, list_value(std::move(all))}});
  }

  std::string name_of(const syntax::SizeRow& row) const { return session_.name_of(module_, row.name()); }

  Session& session_;
  const Scope& scope_;
  const Module& module_;
  const syntax::Sizes& written_;
  const std::string table_;
  std::vector<SizeMeasures> rows_;
  bool sound_ = true;
};

}  // namespace

void define_sizes(Session& session, Scope& scope, const syntax::Sizes& written) {
  define(session, scope, written.name(),
         [&session, &scope, written]() -> Value { return SizesReader(session, scope, written).read(); });
}

void report_unused_size(Session& session) {
  if (session.size.empty() || !session.size_tables.empty()) return;
  const FileId file = session.sources.add(Source("--size", session.size));
  session.report.add(Problem("E0118", fmt::format("this script has no size table, so no size `{}`", session.size))
                         .at({file, {0, static_cast<std::uint32_t>(session.size.size())}})
                         .help("sizes women(waist, hip) { ... }"));
}

std::vector<std::string> common_sizes(const Session& session) {
  if (session.size_tables.empty()) return {};
  std::vector<std::string> common = session.size_tables.front();
  for (const std::vector<std::string>& table : session.size_tables) {
    std::erase_if(common, [&table](const std::string& name) { return std::ranges::find(table, name) == table.end(); });
  }
  return common;
}

}  // namespace toile
