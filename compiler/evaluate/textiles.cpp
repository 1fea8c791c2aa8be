// The colours of a cloth's threads.
#include <algorithm>
#include <map>

#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/fabrics.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

class TextileReader {
 public:
  TextileReader(Session& session, const Scope& scope, const syntax::Textile& written)
      : session_(session), scope_(scope), module_(scope.module()), written_(written) {}

  std::optional<Textile> read() {
    textile_.name = session_.name_of(module_, written_.name());
    for (const syntax::View item : syntax::items(written_)) {
      if (const auto row = syntax::as<syntax::Row>(item)) read_row(*row);
    }
    if (!sound_) return std::nullopt;
    // Threads that are not told of take the first colour of those that are.
    if (warp_.empty() && !weft_.empty()) warp_ = {{weft_.front().colour, 1}};
    if (weft_.empty() && !warp_.empty()) weft_ = {{warp_.front().colour, 1}};
    if (!warp_.empty()) textile_.warp = stripes(warp_);
    if (!weft_.empty()) textile_.weft = stripes(weft_);
    return textile_;
  }

 private:
  struct Threads {
    Colour colour;
    double count = 0;
  };

  void read_row(const syntax::Row& row) {
    const auto token = row.name();
    if (!token) return;
    const std::string name = session_.name_of(module_, token);
    const std::vector<std::string> known{"warp", "weft", "thread", "colour"};
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      report_unknown(session_, module_, *token, "a textile has no row `" + name + "`", known, "E0402");
      sound_ = false;
      return;
    }
    if (const auto [earlier, is_new] = seen_.try_emplace(name, module_.at(*token)); !is_new) {
      session_.report.add(Problem("E0404", "row `" + name + "` is given twice")
                              .at(module_.at(*token), "again here")
                              .also(earlier->second, "first here"));
      sound_ = false;
      return;
    }
    if (module_.broken(row.span())) {
      sound_ = false;
      return;
    }
    if (name == "warp") warp_ = threads(row);
    if (name == "weft") weft_ = threads(row);
    if (name == "thread") read_pitch(row);
    if (name == "colour") read_colour(row);
  }

  void read_pitch(const syntax::Row& row) {
    const std::vector<syntax::Expr> values = row.values();
    if (values.empty()) return;
    const Wanted wanted{session_, scope_};
    const auto pitch = wanted.positive(values.front(), dimension::length, "the pitch of threads");
    if (pitch) pitch_ = *pitch;
    if (!pitch) sound_ = false;
  }

  void read_colour(const syntax::Row& row) {
    const std::vector<syntax::Expr> values = row.values();
    if (values.empty()) return;
    const std::optional<Colour> colour = read_colour(values.front());
    if (!colour) return;
    warp_ = {{*colour, 1}};
    weft_ = warp_;
  }

  std::optional<Colour> read_colour(const syntax::Expr& expr) {
    const Value value = evaluate(session_, scope_, expr);
    if (const auto* colour = value.as<Colour>()) return *colour;
    sound_ = false;
    if (!value.unknown()) {
      session_.report.add(Problem("E0406", "a colour is wanted here, and this is " + describe(value))
                              .at(module_.at(expr), describe(value))
                              .help("colours are written like #1f3a5f"));
    }
    return std::nullopt;
  }

  /// Pairs of a count and a colour; a lone colour fills the whole.
  std::vector<Threads> threads(const syntax::Row& row) {
    const std::vector<syntax::Expr> values = row.values();
    std::vector<Threads> all;
    if (values.size() == 1) {
      if (const auto colour = read_colour(values.front())) all.push_back({*colour, 1});
      return all;
    }
    const Wanted wanted{session_, scope_};
    for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
      const auto count = wanted.count(values[i], "a count of threads");
      const auto colour = read_colour(values[i + 1]);
      if (!count || !colour) {
        sound_ = false;
        continue;
      }
      all.push_back({*colour, static_cast<double>(*count)});
    }
    if (values.size() % 2 != 0) {
      sound_ = false;
      session_.report.add(Problem("E0406", "threads come in pairs of a count and a colour")
                              .at(module_.at(values.back()), "this has no partner")
                              .help("warp 8, #1f3a5f, 2, #ffffff"));
    }
    sound_ = sound_ && !all.empty();
    return all;
  }

  std::vector<Stripe> stripes(const std::vector<Threads>& threads) const {
    std::vector<Stripe> made;
    for (const Threads& each : threads) made.push_back({each.colour, each.count * pitch_});
    return made;
  }

  Session& session_;
  const Scope& scope_;
  const Module& module_;
  const syntax::Textile& written_;
  Textile textile_;
  std::vector<Threads> warp_;
  std::vector<Threads> weft_;
  double pitch_ = 0.5e-3;  // [m] twenty threads a centimetre
  std::map<std::string, Location> seen_;
  bool sound_ = true;
};

}  // namespace

void define_textile(Session& session, Scope& scope, const syntax::Textile& written) {
  define(session, scope, written.name(), [&session, &scope, written]() -> Value {
    auto textile = TextileReader(session, scope, written).read();
    if (!textile) return Unknown{};
    return TextileValue{std::make_shared<const Textile>(std::move(*textile))};
  });
}

}  // namespace toile
