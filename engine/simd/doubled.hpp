// Two registers of lanes side by side. A contact's arithmetic is one long chain of dependent instructions; a second
// chain beside it keeps the processor busy while the first waits.
#pragma once

#include <cstddef>
#include <cstdint>

namespace packstone::engine::simd {

template <class Half>
struct Doubled {
  static constexpr int width = 2 * Half::width;
  static constexpr const char* name = Half::name;
  using HalfReal = typename Half::Real;
  using HalfMask = typename Half::Mask;

  struct Mask {
    HalfMask a, b;

    friend Mask operator&(Mask m, Mask n) { return {m.a & n.a, m.b & n.b}; }
    friend Mask operator|(Mask m, Mask n) { return {m.a | n.a, m.b | n.b}; }
    friend bool any(Mask m) { return any(m.a | m.b); }
    friend std::uint32_t bits(Mask m) { return bits(m.a) | bits(m.b) << Half::width; }
  };

  struct Real {
    HalfReal a, b;

    Real() = default;
    Real(double x) : a(x), b(x) {}
    Real(HalfReal x, HalfReal y) : a(x), b(y) {}

    friend Real operator+(Real x, Real y) { return {x.a + y.a, x.b + y.b}; }
    friend Real operator-(Real x, Real y) { return {x.a - y.a, x.b - y.b}; }
    friend Real operator*(Real x, Real y) { return {x.a * y.a, x.b * y.b}; }
    friend Real operator/(Real x, Real y) { return {x.a / y.a, x.b / y.b}; }
    friend Real operator-(Real x) { return {-x.a, -x.b}; }
    Real& operator+=(Real y) { return *this = *this + y; }
    Real& operator-=(Real y) { return *this = *this - y; }
    Real& operator*=(Real y) { return *this = *this * y; }
    friend Mask operator<(Real x, Real y) { return {x.a < y.a, x.b < y.b}; }
    friend Mask operator>(Real x, Real y) { return {x.a > y.a, x.b > y.b}; }

    friend Real fused(Real x, Real y, Real z) { return {fused(x.a, y.a, z.a), fused(x.b, y.b, z.b)}; }
    friend Real fused_where(Mask m, Real x, Real y, Real z) {
      return {fused_where(m.a, x.a, y.a, z.a), fused_where(m.b, x.b, y.b, z.b)};
    }
    friend Real select(Mask m, Real x, Real y) { return {select(m.a, x.a, y.a), select(m.b, x.b, y.b)}; }
    friend Real only(Mask m, Real x) { return {only(m.a, x.a), only(m.b, x.b)}; }
    friend Real larger(Real x, Real y) { return {larger(x.a, y.a), larger(x.b, y.b)}; }
    friend Real smaller(Real x, Real y) { return {smaller(x.a, y.a), smaller(x.b, y.b)}; }
    friend Real absolute(Real x) { return {absolute(x.a), absolute(x.b)}; }
    friend Real nearest_integer(Real x) { return {nearest_integer(x.a), nearest_integer(x.b)}; }
    friend Real inverse_sqrt(Real x) { return {inverse_sqrt(x.a), inverse_sqrt(x.b)}; }
    friend double sum(Real x) { return sum(x.a + x.b); }
    friend double largest(Real x) { return largest(larger(x.a, x.b)); }
  };

  static Real load(const double* p) { return {Half::load(p), Half::load(p + Half::width)}; }
  static void store(double* p, Real x) {
    Half::store(p, x.a);
    Half::store(p + Half::width, x.b);
  }
  static double lane(Real x, int k) {
    return k < Half::width ? Half::lane(x.a, k) : Half::lane(x.b, k - Half::width);
  }
  static Mask mask(std::uint32_t lanes) { return {Half::mask(lanes), Half::mask(lanes >> Half::width)}; }
  static Real gather(const double* table, const std::int32_t* index) {
    return {Half::gather(table, index), Half::gather(table, index + Half::width)};
  }

  template <int columns, std::size_t stride>
  [[gnu::always_inline]] static void read_columns(const double* base, const std::int32_t* index, Real* column) {
    HalfReal a[columns], b[columns];
    Half::template read_columns<columns, stride>(base, index, a);
    Half::template read_columns<columns, stride>(base, index + Half::width, b);
    for (int c = 0; c < columns; ++c) column[c] = {a[c], b[c]};
  }
  template <int columns, std::size_t stride>
  [[gnu::always_inline]] static void read_columns(const double* rows, Real* column) {
    HalfReal a[columns], b[columns];
    Half::template read_columns<columns, stride>(rows, a);
    Half::template read_columns<columns, stride>(rows + stride * Half::width, b);
    for (int c = 0; c < columns; ++c) column[c] = {a[c], b[c]};
  }
  template <std::size_t stride>
  [[gnu::always_inline]] static void write_columns(double* rows, const Real* column) {
    HalfReal a[4], b[4];
    for (int c = 0; c < 4; ++c) {
      a[c] = column[c].a;
      b[c] = column[c].b;
    }
    Half::template write_columns<stride>(rows, a);
    Half::template write_columns<stride>(rows + stride * Half::width, b);
  }
};

}  // namespace packstone::engine::simd
