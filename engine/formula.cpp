#include "engine/formula.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <muParser.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::engine {

struct Formula::Impl {
  std::string text;
  mu::Parser parser;
  std::vector<double> values;
};

Formula::Formula(const std::string& text, const std::vector<std::string>& variables)
    : impl_(new Impl{text, {}, std::vector<double>(variables.size(), 1.0)}) {
  try {
    impl_->parser.DefineConst("pi", std::numbers::pi);
    impl_->parser.DefineFun("floor", [](double x) { return std::floor(x); });
    impl_->parser.DefineFun("mod", [](double x, double period) { return x - period * std::floor(x / period); });
    for (std::size_t k = 0; k < variables.size(); ++k) impl_->parser.DefineVar(variables[k], &impl_->values[k]);
    impl_->parser.SetExpr(text);
    impl_->parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    throw InputError(fmt::format("\"{}\" is no formula in {}: {}", text, joined(variables), error.GetMsg()));
  }
}

Formula::Formula(Formula&&) noexcept = default;
Formula::~Formula() = default;

double Formula::operator()(std::initializer_list<double> values) const {
  std::copy(values.begin(), values.end(), impl_->values.begin());
  return impl_->parser.Eval();
}

const std::string& Formula::text() const { return impl_->text; }

Formula formula_of(const Scene& scene, const std::string& path, const std::string& text,
                   const std::vector<std::string>& variables) {
  try {
    return Formula(text, variables);
  } catch (const InputError& error) {
    scene.fail(path, error.what());
  }
}

}  // namespace packstone::engine
