// PEGTL's own analysis of the grammar: no rule can call itself without having read something, nothing loops in place.
#include <gtest/gtest.h>

#include <tao/pegtl/contrib/analyze.hpp>

#include "grammar/rules.hpp"

// Our own combinators in PEGTL's terms. Those without rules in them only look or only skip.
namespace tao::pegtl {

namespace syntax = toile::syntax;

template <typename Name, syntax::Kind K, typename... Rules>
struct analyze_traits<Name, syntax::token<K, Rules...>> : analyze_seq_traits<Rules...> {};
template <typename Name, syntax::Kind K>
struct analyze_traits<Name, syntax::spelled<K>> : analyze_any_traits<> {};
template <typename Name, syntax::Kind K, typename... Rules>
struct analyze_traits<Name, syntax::node<K, Rules...>> : analyze_seq_traits<Rules...> {};
template <typename Name, syntax::Kind K, typename Rule>
struct analyze_traits<Name, syntax::called<K, Rule>> : analyze_seq_traits<Rule> {};
template <typename Name, syntax::Kind Open, syntax::Kind Close, typename... Rules>
struct analyze_traits<Name, syntax::bracketed<Open, Close, Rules...>>
    : analyze_seq_traits<syntax::sign<Open>, Rules..., syntax::sign<Close>> {};
template <typename Name, syntax::Kind K, typename Head, typename Recovery, typename... Parts>
struct analyze_traits<Name, syntax::statement<K, Head, Recovery, Parts...>> : analyze_seq_traits<Head, opt<Parts>...> {
};
template <typename Name, syntax::Kind K, syntax::StatementWords Words, char Separator, typename Item>
struct analyze_traits<Name, syntax::items_in_braces<K, Words, Separator, Item>>
    : analyze_seq_traits<syntax::sign<syntax::Kind::LeftBrace>, star<Item>> {};

template <typename Name>
struct analyze_traits<Name, syntax::more> : analyze_opt_traits<> {};
template <typename Name, syntax::Kind K>
struct analyze_traits<Name, syntax::perhaps_on_next_line<K>> : analyze_opt_traits<> {};
template <typename Name, char... Others>
struct analyze_traits<Name, syntax::at_end<Others...>> : analyze_opt_traits<> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::at_closing_brace> : analyze_opt_traits<> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::unreserved> : analyze_opt_traits<> {};
template <typename Name, syntax::StatementWords Words>
struct analyze_traits<Name, syntax::rules::not_outside<Words>> : analyze_opt_traits<> {};

template <typename Name>
struct analyze_traits<Name, syntax::rules::end_of_part> : analyze_seq_traits<syntax::rules::operators> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::before_list> : analyze_opt_traits<> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::named_next> : analyze_opt_traits<> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::closed_insertion> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::more_inserted> : analyze_opt_traits<> {};
template <typename Name, typename Rule>
struct analyze_traits<Name, syntax::gap_before<Rule>> : analyze_seq_traits<Rule> {};

template <typename Name>
struct analyze_traits<Name, syntax::rules::unit_word> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::unit> : analyze_seq_traits<syntax::rules::unit_text> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::postfix>
    : analyze_seq_traits<syntax::rules::primary, star<syntax::rules::tail>> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::operators>
    : analyze_seq_traits<syntax::rules::prefixes, syntax::rules::postfix, star<syntax::rules::infix>> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::expression>
    : analyze_sor_traits<syntax::rules::choice, syntax::rules::operators> {};
template <typename Name>
struct analyze_traits<Name, syntax::rules::file> : analyze_opt_traits<star<syntax::rules::file_item>> {};

}  // namespace tao::pegtl

namespace toile::syntax {
namespace {

TEST(Grammar, MakesProgress) {
  EXPECT_EQ(pegtl::analyze<rules::file>(), 0u);
}

/// `x = x` must be noticed, or the test above would prove nothing.
struct endless : node<Kind::Let, pegtl::opt<sign<Kind::Comma>>, endless> {};
TEST(Grammar, AnalysisSeesThroughOurCombinators) {
  EXPECT_GT(pegtl::analyze<endless>(-1), 0u);
}

}  // namespace
}  // namespace toile::syntax
