# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas: texts, or functions that are called once with symbols, become lists of operations that the compiled part evaluates.

Texts are read by Python's own parser; nothing of them is executed. Functions are called with symbols in place of numbers, which note
what is done to them; NumPy hands its own functions over to the symbols.
"""
from __future__ import annotations

import ast
import math
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core


class FormulaError(ValueError):
    """A formula that cannot be read; the message says what to change."""


class CannotTrace(TypeError):
    """A function does something with its arguments that is not a formula, so that it has to be called for each point."""


Operand = Union["Symbol", int, float]


class Program:
    """A list of operations; equal ones are in it once."""

    def __init__(self, variables: Sequence[str]):
        self.instructions: List[Tuple[str, Tuple[int, int, int], float]] = []
        self._known: Dict[Tuple[str, Tuple[int, int, int], float], int] = {}
        self.variables = [self.add("variable", (i, 0, 0)) for i in range(len(variables))]

    def add(self, operation: str, operands: Tuple[int, int, int] = (0, 0, 0), number: float = 0.0) -> "Symbol":
        key = (operation, operands, number)
        # -0.0 and 0.0 are equal, but divide differently
        if number == 0 and math.copysign(1, number) < 0:
            key = (operation + "-", operands, number)
        if key not in self._known:
            self._known[key] = len(self.instructions)
            self.instructions.append((operation, operands, number))
        return Symbol(self, self._known[key])

    def symbol(self, value: Any) -> "Symbol":
        """A symbol as it is, a number as a constant."""
        if isinstance(value, Symbol):
            if value.program is not self:
                raise CannotTrace("symbols of two formulas are mixed")
            return value
        if isinstance(value, np.ndarray) and value.ndim == 0:
            value = value.item()
            if isinstance(value, Symbol):
                return self.symbol(value)
        if isinstance(value, (bool, np.bool_, int, float, np.integer, np.floating)):
            return self.add("number", (0, 0, 0), float(value))
        raise CannotTrace(f"{type(value).__name__} is no number")

    def apply(self, operation: str, *operands: Any) -> "Symbol":
        symbols = [self.symbol(operand) for operand in operands]
        indices = tuple(s.index for s in symbols) + (0,) * (3 - len(symbols))
        return self.add(operation, indices)  # type: ignore[arg-type]

    def number_of(self, symbol: "Symbol") -> Optional[float]:
        """The value of a constant, or None."""
        operation, _, number = self.instructions[symbol.index]
        return number if operation == "number" else None

    def power(self, base: Any, exponent: Any) -> "Symbol":
        base, exponent = self.symbol(base), self.symbol(exponent)
        number = self.number_of(exponent)
        if number is None:
            return self.apply("power", base, exponent)
        if number == 0.5:
            return self.apply("sqrt", base)
        largest_product = 8
        if number == int(number) and 1 <= abs(number) <= largest_product:
            result = self._product(base, int(abs(number)))
            return result if number > 0 else self.apply("divide", 1, result)
        return self.add("power_of_number", (base.index, 0, 0), number)

    def _product(self, base: "Symbol", n: int) -> "Symbol":
        if n == 1:
            return base
        half = self._product(base, n // 2)
        square = self.apply("multiply", half, half)
        return self.apply("multiply", square, base) if n % 2 else square

    def compiled(self, results: Sequence[Any]) -> _core.Formula:
        indices = [self.symbol(result).index for result in results]
        return _core.Formula(self.instructions, indices)


def _binary(operation: str, is_reflected: bool = False) -> Callable[["Symbol", Any], "Symbol"]:
    def method(self: "Symbol", other: Any) -> "Symbol":
        if isinstance(other, np.ndarray) and other.ndim > 0:
            return NotImplemented  # NumPy does it for each element
        return self.program.apply(operation, *((other, self) if is_reflected else (self, other)))
    return method


class Symbol:
    """What a function is called with in place of a number; it notes what is done to it."""

    __slots__ = ("program", "index")

    def __init__(self, program: Program, index: int):
        self.program = program
        self.index = index

    __add__, __radd__ = _binary("add"), _binary("add", True)
    __sub__, __rsub__ = _binary("subtract"), _binary("subtract", True)
    __mul__, __rmul__ = _binary("multiply"), _binary("multiply", True)
    __truediv__, __rtruediv__ = _binary("divide"), _binary("divide", True)
    __lt__, __gt__ = _binary("less"), _binary("less", True)
    __le__, __ge__ = _binary("less_equal"), _binary("less_equal", True)
    __hash__ = None  # type: ignore[assignment]

    def __eq__(self, other: Any) -> Any:
        return self.program.apply("equal", self, other)

    def __ne__(self, other: Any) -> Any:
        return 1 - (self == other)

    def __and__(self, other: Any) -> "Symbol":
        return self.program.apply("select", self, other, 0)

    def __or__(self, other: Any) -> "Symbol":
        return self.program.apply("select", self, 1, other)

    def __invert__(self) -> "Symbol":
        return self == 0

    def __neg__(self) -> "Symbol":
        return self.program.apply("negative", self)

    def __pos__(self) -> "Symbol":
        return self

    def __abs__(self) -> "Symbol":
        return self.program.apply("abs", self)

    def __pow__(self, other: Any) -> "Symbol":
        return self.program.power(self, other)

    def __rpow__(self, other: Any) -> "Symbol":
        return self.program.power(other, self)

    def __bool__(self) -> bool:
        raise CannotTrace("the function decides by the value of its arguments")

    def _refuse(self, *_: Any) -> Any:
        raise CannotTrace("the function needs the value of its arguments")

    __float__ = __int__ = __complex__ = __index__ = __iter__ = _refuse

    @property
    def shape(self) -> Tuple[int, ...]:
        return ()

    @property
    def ndim(self) -> int:
        return 0

    @property
    def dtype(self) -> np.dtype:
        return np.dtype(float)

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        function: Any = FUNCTIONS.get(ufunc.__name__)
        if method != "__call__" or options or function is None:
            raise CannotTrace(f"numpy.{ufunc.__name__} is no operation of a formula")
        if any(isinstance(x, np.ndarray) and x.ndim > 0 for x in inputs):
            return np.vectorize(lambda *xs: function(self.program, *xs), otypes=[object])(*inputs)
        return function(self.program, *inputs)

    def __array_function__(self, function: Any, types: Any, arguments: Any, options: Any) -> Any:
        name = function.__name__
        if name == "where" and len(arguments) == 3:
            return self.program.apply("select", *arguments)
        if name in ("zeros_like", "ones_like"):
            return 0.0 if name == "zeros_like" else 1.0
        if name == "full_like":
            return arguments[1]
        if name in ("stack", "vstack", "hstack", "column_stack", "dstack"):
            return tuple(arguments[0])
        raise CannotTrace(f"numpy.{name} is no operation of a formula")


def _named(operation: str) -> Callable[..., Symbol]:
    return lambda program, *operands: program.apply(operation, *operands)


# By the names of NumPy. What is not an operation of the compiled part is composed.
FUNCTIONS: Dict[str, Callable[..., Symbol]] = {
    name: _named(name) for name in ("add", "subtract", "multiply", "divide", "negative", "less", "less_equal", "equal", "minimum",
                                    "maximum", "sqrt", "cbrt", "exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh")}
FUNCTIONS.update({
    "true_divide": _named("divide"), "fmin": _named("minimum"), "fmax": _named("maximum"),
    "arcsin": _named("asin"), "arccos": _named("acos"), "arctan": _named("atan"), "arctan2": _named("atan2"),
    "arcsinh": _named("asinh"), "arccosh": _named("acosh"), "arctanh": _named("atanh"), "erf": _named("erf"),
    "absolute": _named("abs"), "fabs": _named("abs"),
    "power": lambda p, x, y: p.power(x, y), "float_power": lambda p, x, y: p.power(x, y),
    "square": lambda p, x: p.apply("multiply", x, x), "reciprocal": lambda p, x: p.apply("divide", 1, x),
    "positive": lambda p, x: p.symbol(x),
    "greater": lambda p, x, y: p.apply("less", y, x), "greater_equal": lambda p, x, y: p.apply("less_equal", y, x),
    "not_equal": lambda p, x, y: p.apply("subtract", 1, p.apply("equal", x, y)),
    "logical_and": lambda p, x, y: p.symbol(x) & y, "logical_or": lambda p, x, y: p.symbol(x) | y,
    "logical_not": lambda p, x: ~p.symbol(x),
    "hypot": lambda p, x, y: p.apply("sqrt", p.symbol(x) * x + p.symbol(y) * y),
    "exp2": lambda p, x: p.apply("exp", p.symbol(x) * math.log(2)), "expm1": lambda p, x: p.apply("exp", x) - 1,
    "log2": lambda p, x: p.apply("log", x) / math.log(2), "log10": lambda p, x: p.apply("log", x) / math.log(10),
    "log1p": lambda p, x: p.apply("log", 1 + p.symbol(x)),
    "deg2rad": lambda p, x: p.symbol(x) * (math.pi / 180), "rad2deg": lambda p, x: p.symbol(x) * (180 / math.pi),
    "radians": lambda p, x: p.symbol(x) * (math.pi / 180), "degrees": lambda p, x: p.symbol(x) * (180 / math.pi),
    "heaviside": lambda p, x, y: p.apply("select", p.apply("equal", x, 0), y, p.apply("less", 0, x)),
    "sign": lambda p, x: p.apply("less", 0, x) - p.apply("less", x, 0),
})


def _method_of(name: str) -> Callable[..., Symbol]:
    return lambda self, *others: FUNCTIONS[name](self.program, self, *others)


for _name in FUNCTIONS:  # NumPy calls them for arrays of symbols
    if not hasattr(Symbol, _name):
        setattr(Symbol, _name, _method_of(_name))

# Of texts: those of Python's module math, and the same in NumPy's names.
NAMES_IN_TEXTS: Dict[str, Callable[..., Symbol]] = {
    **{name: FUNCTIONS[name] for name in ("sqrt", "cbrt", "exp", "exp2", "expm1", "log", "log2", "log10", "log1p", "sin", "cos", "tan",
                                          "sinh", "cosh", "tanh", "arcsin", "arccos", "arctan", "arctan2", "arcsinh", "arccosh", "arctanh",
                                          "erf", "hypot", "minimum", "maximum", "sign", "square", "radians", "degrees")},
    "asin": FUNCTIONS["arcsin"], "acos": FUNCTIONS["arccos"], "atan": FUNCTIONS["arctan"], "atan2": FUNCTIONS["arctan2"],
    "asinh": FUNCTIONS["arcsinh"], "acosh": FUNCTIONS["arccosh"], "atanh": FUNCTIONS["arctanh"], "ln": FUNCTIONS["log"],
    "abs": FUNCTIONS["absolute"], "fabs": FUNCTIONS["absolute"], "min": FUNCTIONS["minimum"], "max": FUNCTIONS["maximum"],
    "pow": FUNCTIONS["power"],
}
NUMBERS_IN_TEXTS = {"pi": math.pi, "tau": 2 * math.pi, "e": math.e}

_OPERATORS = {ast.Add: "add", ast.Sub: "subtract", ast.Mult: "multiply", ast.Div: "divide", ast.Pow: "power"}
_COMPARISONS = {ast.Lt: "less", ast.LtE: "less_equal", ast.Gt: "greater", ast.GtE: "greater_equal", ast.Eq: "equal", ast.NotEq: "not_equal"}


class _Reader(ast.NodeVisitor):
    """Turns the tree of a text into operations."""

    def __init__(self, text: str, variables: Sequence[str]):
        self.text = text
        self.program = Program(variables)
        self.names: Dict[str, Any] = {**NUMBERS_IN_TEXTS, **dict(zip(variables, self.program.variables))}
        self.variables = variables

    def refuse(self, what: str) -> FormulaError:
        most = 200  # characters of a long formula that are enough to recognize it
        text = self.text if len(self.text) <= most else self.text[:most] + "..."
        return FormulaError(f"the formula '{text}' {what}")

    def generic_visit(self, node: ast.AST) -> Any:
        raise self.refuse(f"has a part that is no arithmetic: '{ast.unparse(node)}'")

    def visit_Expr(self, node: ast.Expr) -> Any:
        return self.visit(node.value)

    def visit_Assign(self, node: ast.Assign) -> None:
        for target in node.targets:
            if not isinstance(target, ast.Name):
                self.generic_visit(node)
            self.names[target.id] = self.visit(node.value)  # type: ignore[attr-defined]

    def visit_Tuple(self, node: ast.Tuple) -> Any:
        return [self.visit(element) for element in node.elts]

    visit_List = visit_Tuple  # type: ignore[assignment]

    def visit_Constant(self, node: ast.Constant) -> Any:
        if isinstance(node.value, bool) or not isinstance(node.value, (int, float)):
            self.generic_visit(node)
        return self.program.symbol(float(node.value))

    def visit_Name(self, node: ast.Name) -> Any:
        if node.id not in self.names:
            hint = ": call it with what it is to be applied to" if node.id in NAMES_IN_TEXTS else ""
            known = ", ".join(self.variables)
            raise self.refuse(f"uses '{node.id}', which is neither a variable ({known}) nor a number that it has set before{hint}")
        return self.names[node.id]

    def visit_UnaryOp(self, node: ast.UnaryOp) -> Any:
        if isinstance(node.op, ast.USub):
            return -self.visit(node.operand)
        if isinstance(node.op, ast.UAdd):
            return self.visit(node.operand)
        if isinstance(node.op, ast.Not):
            return ~self.visit(node.operand)
        return self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> Any:
        if isinstance(node.op, ast.BitXor):
            raise self.refuse("has a '^'; powers are written '**', as in Python")
        if type(node.op) not in _OPERATORS:
            return self.generic_visit(node)
        return FUNCTIONS[_OPERATORS[type(node.op)]](self.program, self.visit(node.left), self.visit(node.right))

    def visit_BoolOp(self, node: ast.BoolOp) -> Any:
        result = self.visit(node.values[0])
        for value in node.values[1:]:
            other = self.visit(value)
            result = result & other if isinstance(node.op, ast.And) else result | other
        return result

    def visit_Compare(self, node: ast.Compare) -> Any:
        operands = [self.visit(operand) for operand in [node.left, *node.comparators]]
        result: Any = None
        for operator, left, right in zip(node.ops, operands, operands[1:]):
            if type(operator) not in _COMPARISONS:
                return self.generic_visit(node)
            one = FUNCTIONS[_COMPARISONS[type(operator)]](self.program, left, right)
            result = one if result is None else result & one
        return result

    def visit_IfExp(self, node: ast.IfExp) -> Any:
        return self.program.apply("select", self.visit(node.test), self.visit(node.body), self.visit(node.orelse))

    def visit_Call(self, node: ast.Call) -> Any:
        name = node.func.id if isinstance(node.func, ast.Name) else ast.unparse(node.func)
        if name not in NAMES_IN_TEXTS:
            raise self.refuse(f"calls '{name}', which is not one of {', '.join(sorted(NAMES_IN_TEXTS))}")
        arguments = [self.visit(argument) for argument in node.args]
        function = NAMES_IN_TEXTS[name]
        expected = 2 if name in ("arctan2", "atan2", "hypot", "minimum", "maximum", "min", "max", "pow") else 1
        if len(arguments) != expected or node.keywords:
            raise self.refuse(f"calls '{name}' with {len(arguments)} arguments; it takes {expected}")
        return function(self.program, *arguments)


def read_formula(text: str, variables: Sequence[str], number_of_results: int) -> _core.Formula:
    """Compiles a text such as ``"u, v, exp(-u*u)"``, with as many results, which commas separate.

    It may begin with definitions that semicolons or ends of lines follow: ``"r = 2 + cos(v); r*cos(u), r*sin(u), sin(v)"``.
    """
    reader = _Reader(text, variables)
    lines = "\n".join(line.strip() for line in text.strip().splitlines())
    try:
        body = ast.parse(lines, mode="exec").body
    except SyntaxError as error:
        raise reader.refuse(f"cannot be read: {error.msg}") from None
    except (RecursionError, MemoryError):
        raise reader.refuse("is nested too deeply; set parts of it before, as in 'r = 2 + cos(v); r*cos(u), r*sin(u), sin(v)'") from None
    except ValueError as error:
        raise reader.refuse(f"cannot be read: {error}") from None
    result: Any = None
    try:
        for statement in body:
            result = reader.visit(statement)
    except RecursionError:
        raise reader.refuse("is nested too deeply; set parts of it before, as in 'r = 2 + cos(v); r*cos(u), r*sin(u), sin(v)'") from None
    results = result if isinstance(result, list) else [] if result is None else [result]
    if len(results) != number_of_results or any(isinstance(r, list) for r in results):
        values = "one value" if number_of_results == 1 else f"{number_of_results} values with commas between"
        raise reader.refuse(f"must end with {values}, and has {len(results)}")
    return reader.program.compiled(results)


def trace(function: Callable[..., Any], variables: Sequence[str], number_of_results: int) -> Optional[_core.Formula]:
    """Calls a function with symbols. Returns what it does as a formula, or None if it is not one."""
    program = Program(variables)
    try:
        with np.errstate(all="ignore"):
            result = function(*program.variables)
        results = [result] if number_of_results == 1 and not isinstance(result, (tuple, list, np.ndarray)) else list(result)
        if len(results) != number_of_results:
            return None  # calling it with numbers tells what is wrong
        return program.compiled(results)
    except Exception:  # whatever the function objects to: it is called with numbers
        return None
