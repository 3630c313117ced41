"""Checks that a type has one definition. The linker takes two of the same name for one and the same, and keeps one of
the two constructors, destructors and inline members for both, without a word.

    /usr/bin/python3 one_definition.py REPOSITORY      prints each second definition as file:line: what, and exits 1
"""
import pathlib
import re
import sys

# What may hold a brace or a semicolon that is none: comments, raw strings, strings, characters, preprocessor lines.
# A quote between digits separates thousands.
NO_CODE = re.compile(r"""//[^\n]* | /\*.*?\*/ | R"([^(\s]*)\(.*?\)\1" | "(?:\\.|[^"\\\n])*" | (?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'
                         | ^[ \t]*\#(?:[^\\\n]|\\.)*""", re.DOTALL | re.MULTILINE | re.VERBOSE)
NAMESPACE = re.compile(r"(?:inline\s+)?namespace\s*([\w:]*)")
TYPE = re.compile(r"\b(?:struct|class|union|enum)\s+(?:alignas\([^)]*\)\s*|\[\[.*?\]\]\s*)*([\w:]+(?:\s*<.*>)?)"
                  r"(?:\s+final)?\s*(?::(?!:).*)?", re.DOTALL)


def code_of(text):
    """The text without what is no code, its lines where they were."""
    return NO_CODE.sub(lambda match: " " + "\n" * match.group().count("\n"), text)


def type_of(head):
    """The name of the type that a brace after this head defines; None where it opens something else."""
    for key in re.finditer(r"\b(?:struct|class|union|enum)\b", head):
        found = TYPE.fullmatch(head, key.start())
        if found:
            return re.sub(r"\s", "", found.group(1))
    return None


def definitions(text):
    """(full name, line) of each type that other files see: those of namespaces with a name."""
    code = code_of(text)
    scopes = []  # names of namespaces; None for a body and for a namespace without a name
    start = 0
    for mark in re.finditer(r"[{};]", code):
        head = code[start:mark.start()].strip()
        start = mark.end()
        if mark.group() == "}":
            scopes.pop()
        elif mark.group() == "{":
            namespace = NAMESPACE.fullmatch(head)
            name = type_of(head)
            if name and None not in scopes:
                yield "::".join(scopes + [name]), code.count("\n", 0, mark.start()) + 1
            scopes.append(namespace.group(1) or None if namespace else None)


def violations(root):
    root = pathlib.Path(root)
    first = {}
    found = []
    for folder in ["include", "src", "tests"]:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            name = path.relative_to(root)
            for what, line in definitions(path.read_text(encoding="utf-8")):
                if what in first:
                    found.append(f"{name}:{line}: {what} is defined in {first[what]}, too; rename one, "
                                 "or put it into a namespace without a name")
                first.setdefault(what, f"{name}:{line}")
    return found


if __name__ == "__main__":
    found = violations(sys.argv[1])
    print("\n".join(found) if found else "every type has one definition")
    sys.exit(1 if found else 0)
