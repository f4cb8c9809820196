// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PYTHON_FORMULA_H
#define PYTHON_FORMULA_H

#include <CGAL/Parametric_surface_mesher/internal/surfaces/Taylor_polynomial_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// A compiled formula: a list of operations on the results of earlier ones. It is evaluated with plain numbers or with numbers that carry
// derivatives. The Python part of the module makes the list, from a text or by calling a function with symbols.
class Formula
{
public:
  enum Operation
  {
    NUMBER, VARIABLE, NEGATIVE, ADD, SUBTRACT, MULTIPLY, DIVIDE, POWER, POWER_OF_NUMBER, SQRT, CBRT, EXP, LOG, SIN, COS, TAN, ASIN, ACOS,
    ATAN, ATAN2, SINH, COSH, TANH, ASINH, ACOSH, ATANH, ERF, ABS, MINIMUM, MAXIMUM, LESS, LESS_EQUAL, EQUAL, SELECT
  };

  struct Instruction
  {
    Operation operation;
    std::array<std::size_t, 3> operands; // indices of earlier instructions; of a variable its number
    double number;                       // a constant, or an exponent
  };

private:
  std::vector<Instruction> m_instructions;
  std::vector<std::size_t> m_results;

public:
  // `results`: indices of the instructions that give the results
  Formula(std::vector<Instruction> instructions, std::vector<std::size_t> results)
    : m_instructions(std::move(instructions)), m_results(std::move(results))
  {
    for(std::size_t i = 0; i < m_instructions.size(); ++i)
      for(std::size_t operand : m_instructions[i].operands)
        if(operand >= i && operand != 0 && m_instructions[i].operation != VARIABLE)
          throw std::invalid_argument("an instruction of a formula refers to a later one");
    for(std::size_t result : m_results)
      if(result >= m_instructions.size())
        throw std::invalid_argument("a result of a formula is no instruction of it");
  }

  std::size_t number_of_results() const { return m_results.size(); }

  // The results in their order. `registers` is room for work, kept from call to call.
  template <std::size_t n, class Number, std::size_t number_of_variables>
  std::array<Number, n> evaluate(const std::array<Number, number_of_variables>& variables, std::vector<Number>& registers) const
  {
    registers.resize(m_instructions.size());
    for(std::size_t i = 0; i < m_instructions.size(); ++i) {
      const Instruction& in = m_instructions[i];
      registers[i] = in.operation == VARIABLE ? variables[in.operands[0]] : calculate(in, registers);
    }
    std::array<Number, n> results;
    for(std::size_t i = 0; i < n; ++i)
      results[i] = registers[m_results[i]];
    return results;
  }

  static Operation operation(const std::string& name)
  {
    static const std::map<std::string, Operation> operations{
      {"number", NUMBER}, {"variable", VARIABLE}, {"negative", NEGATIVE}, {"add", ADD}, {"subtract", SUBTRACT}, {"multiply", MULTIPLY},
      {"divide", DIVIDE}, {"power", POWER}, {"power_of_number", POWER_OF_NUMBER}, {"sqrt", SQRT}, {"cbrt", CBRT}, {"exp", EXP},
      {"log", LOG},
      {"sin", SIN}, {"cos", COS}, {"tan", TAN}, {"asin", ASIN}, {"acos", ACOS}, {"atan", ATAN}, {"atan2", ATAN2}, {"sinh", SINH},
      {"cosh", COSH}, {"tanh", TANH}, {"asinh", ASINH}, {"acosh", ACOSH}, {"atanh", ATANH}, {"erf", ERF}, {"abs", ABS},
      {"minimum", MINIMUM}, {"maximum", MAXIMUM}, {"less", LESS}, {"less_equal", LESS_EQUAL}, {"equal", EQUAL}, {"select", SELECT}};
    const auto found = operations.find(name);
    if(found == operations.end())
      throw std::invalid_argument("'" + name + "' is no operation of a formula");
    return found->second;
  }

private:
  template <class Number>
  static Number calculate(const Instruction& in, const std::vector<Number>& registers)
  {
    using namespace CGAL::Parametric_surface_mesher::internal;
    using std::sqrt; using std::cbrt; using std::exp; using std::log; using std::pow; using std::fabs; using std::erf;
    using std::sin; using std::cos; using std::tan; using std::asin; using std::acos; using std::atan; using std::atan2;
    using std::sinh; using std::cosh; using std::tanh; using std::asinh; using std::acosh; using std::atanh;
    const Number &a = registers[in.operands[0]], &b = registers[in.operands[1]], &c = registers[in.operands[2]];
    switch(in.operation) {
    case NEGATIVE: return -a;
    case ADD: return a + b;
    case SUBTRACT: return a - b;
    case MULTIPLY: return a * b;
    case DIVIDE: return a / b;
    case POWER: return pow(a, b);
    case POWER_OF_NUMBER: return pow(a, in.number);
    case SQRT: return sqrt(a);
    case CBRT: return cbrt(a);
    case EXP: return exp(a);
    case LOG: return log(a);
    case SIN: return sin(a);
    case COS: return cos(a);
    case TAN: return tan(a);
    case ASIN: return asin(a);
    case ACOS: return acos(a);
    case ATAN: return atan(a);
    case ATAN2: return atan2(a, b);
    case SINH: return sinh(a);
    case COSH: return cosh(a);
    case TANH: return tanh(a);
    case ASINH: return asinh(a);
    case ACOSH: return acosh(a);
    case ATANH: return atanh(a);
    case ERF: return erf(a);
    case ABS: return fabs(a);
    case MINIMUM: return b < a ? b : a;
    case MAXIMUM: return a < b ? b : a;
    case LESS: return Number(a < b ? 1. : 0.);
    case LESS_EQUAL: return Number(a <= b ? 1. : 0.);
    case EQUAL: return Number(a == b ? 1. : 0.);
    case SELECT: return a == Number(0.) ? c : b;
    default: return Number(in.number);
    }
  }
};

#endif // PYTHON_FORMULA_H
