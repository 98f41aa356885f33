# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that no folder has more than 25 source files, no source file more than 600 lines and no function more
than 70, signature and braces included; lambdas count with what they stand in. Folders of tests have the limits of
files and functions only."""

import ast
import collections
import re

MODULES = ("base", "case", "scene", "result", "contact", "halfspace", "theories", "profiles", "track", "meshes", "fem",
           "hybrid", "modelling", "postprocess", "tables", "convert", "app", "bindings", "benchmarks", "tests")
MOST_FILES = 25
MOST_LINES = 600
MOST_IN_FUNCTION = 70

TEXT_OR_COMMENT = re.compile(r'R"\((.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*.*?\*/', re.S)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)
SCOPE = re.compile(r"^(?:(?:inline|export|typedef|static)\s+)*(?:namespace|class|struct|union|extern)\b(?!.*\)\s*\w*$)", re.S)
FUNCTION = re.compile(r"\)(?:\s*(?:const|noexcept|override|final|mutable|&&?|try|->[^{}()]*|\(\)))*$")


def blank(match):
    """Replaces text by a word, keeping the number of lines."""
    return ("_" if match[0][0] in "R\"'" else "") + "\n" * match[0].count("\n")


def cpp_functions(text):
    """(name, first line, last line) of the functions at the level of namespaces and classes."""
    text = DIRECTIVE.sub(blank, TEXT_OR_COMMENT.sub(blank, text))
    stack, head, first, line = [], "", 1, 1
    for character in text:
        inside = "other" in stack or "function" in stack
        if character == "{":
            kind = "other"
            if not inside:
                sense = re.sub(r"\btemplate\s*<[^{}]*?>\s*(?=[\w:])", "", head.strip())
                kind = "scope" if SCOPE.match(sense) else "function" if FUNCTION.search(sense) else "other"
                if kind == "function":
                    name = re.search(r"([\w:~]+|operator\S+)\s*\(", sense)
                    begun = (name[1] if name else "?", first)
            stack.append(kind)
            if kind == "scope":
                head = ""
        elif character == "}":
            kind = stack.pop()
            if kind == "function":
                yield (*begun, line)
            if "other" not in stack and "function" not in stack:
                head = head + "()" if kind == "other" else ""
        elif character == ";" and not inside:
            head = ""
        elif not inside:
            if not head and not character.isspace():
                first = line
            if head or not character.isspace():
                head += character
        if character == "\n":
            line += 1


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.name, node.lineno, node.end_lineno


def problems(root):
    self_test()
    for module in MODULES:
        sources = [path for path in sorted((root / module).rglob("*")) if path.suffix in (".cpp", ".hpp", ".py")]
        for folder, files in sorted(collections.Counter(path.parent for path in sources).items()):
            if files > MOST_FILES and module != "tests":
                yield f"{folder.relative_to(root)} has {files} files; allowed: {MOST_FILES}; do: make rooms of it"
        for path in sources:
            text = path.read_text(encoding="utf-8")
            name = path.relative_to(root).as_posix()
            functions = (python_functions if path.suffix == ".py" else cpp_functions)(text)
            sizes = [(name, len(text.splitlines()) - 1, MOST_LINES)]  # the licence is not counted
            sizes += [(f"{name}:{function}", last - first + 1, MOST_IN_FUNCTION) for function, first, last in functions]
            for what, lines, most in sizes:
                if lines > most:
                    yield f"{what} has {lines} lines; allowed: {most}; do: divide it by what it does"


def self_test():
    """Tests the checker itself, because one that cannot fail is useless."""
    text = """namespace a {
template <class T>
struct B : C<T> {  // not a function {
  B(int x)
      : x_{x}, y_(x) {
    if (x) { const auto f = [] { return "}"; }; f(); }
  }
  auto f() const -> int { return 1; }
  int x_ = 0, y_[2] = {1, 2};
};
enum class E { one, two };
const std::vector<int> list{1, 2};
TEST(Suite, Name) {

}
template <class T, class = std::enable_if_t<true>>
struct G g(
    int x) noexcept {
}
}"""
    assert [(name, first, last) for name, first, last in cpp_functions(text)] == [
        ("B", 4, 7), ("f", 8, 8), ("TEST", 13, 15), ("g", 16, 19)], list(cpp_functions(text))
    assert list(python_functions("def f():\n    pass\n")) == [("f", 1, 2)]
