"""Mutations of the sources: drawn by a seed, and written beside what they replace.

`rolling_contact_mutant(7) ? changed : original` stands in the place of the original, so that one build holds all
mutations and an environment variable chooses one. Comments, includes, asserts, messages of exceptions and what is
constexpr are left alone.
"""
import bisect
import random
import re

# how many of 60 mutations an operator gets; "unit in text", "word in text" and "unit factor" are what the user reads
SHARES = {"unit in text": 9, "word in text": 7, "unit factor": 4, "constant": 7, "sign": 7, "comparison": 6, "index": 5,
          "arguments": 4, "function": 4, "condition": 4, "assignment": 3}
READ = ("unit in text", "word in text", "unit factor")
UNITS = {"m": "mm", "mm": "m", "um": "mm", "N": "kN", "kN": "N", "Pa": "MPa", "MPa": "Pa", "GPa": "MPa", "s": "ms",
         "ms": "s", "Hz": "kHz", "kHz": "Hz", "rad": "deg", "deg": "rad", "degrees": "rad", "W": "kW", "kW": "W",
         "J": "kJ", "kJ": "J", "K": "degC", "kg": "t", "%": "", "percent": "share", "dB": "B", "h": "s", "km": "m",
         "mm2": "m2", "m2": "mm2", "seconds": "minutes", "GB": "MB", "MB": "GB"}
WORDS = [("longitudinal", "lateral"), ("wheel", "rail"), ("left", "right"), ("first", "last"), ("largest", "smallest"),
         ("largest", "mean"), ("min", "max"), ("above", "below"), ("before", "after"), ("normal", "tangential"),
         ("pressure", "traction"), ("force", "moment"), ("speed", "frequency"), ("wear", "heat"), ("stick", "slip"),
         ("inner", "outer"), ("upper", "lower"), ("real", "imaginary"), ("begin", "end"), ("start", "end"), ("more", "less"),
         ("with", "without"), ("x", "y"), ("width", "length"), ("radius", "width"), ("mass", "stiffness"),
         ("displacement", "velocity"), ("stable", "unstable"), ("rows", "columns")]
FUNCTIONS = [("std::sin(", "std::cos("), ("std::min(", "std::max("), ("std::floor(", "std::ceil("), (".front()", ".back()"),
             (".real()", ".imag()"), (".rows()", ".cols()"), (".first", ".second"), ("std::abs(", "("), ("std::sqrt(", "("),
             (" && ", " || "), (" * ", " / ")]
FACTOR = r"1e[36]|1e9|1e-[36]|1000\.?|180\.?|3\.6|3600\.?|360\.?"
SYMMETRIC = {"min", "max", "hypot", "swap", "minmax", "is_near", "near", "abs", "if", "while", "for", "switch", "return"}
NAME = r"[\w.:\->\[\]]+(?:(?<!end)(?<!begin)\(\))?"

HEADER = """#pragma once
// written by tests/campaigns/mutations
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <unistd.h>
inline bool rolling_contact_mutant(const int number)
{
  static const char *const text = std::getenv("ROLLING_CONTACT_MUTANT");
  static const int chosen = text == nullptr ? 0 : std::atoi(text);
  static const char *const folder = std::getenv("ROLLING_CONTACT_MUTANTS_REACHED");
  static bool reached[10000] = {};
  if (folder != nullptr && !reached[number])
    {
      reached[number] = true;
      const int file = open((std::string(folder) + "/" + std::to_string(number)).c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0666);
      if (file >= 0)
        close(file);
    }
  return chosen == number;
}
"""


def closing(code, at):
    """The place of the bracket that closes the one at a place."""
    depth = 0
    for k in range(at, len(code)):
        depth += (code[k] in "([{") - (code[k] in ")]}")
        if depth == 0:
            return k
    return len(code) - 1


class Source:
    """A file: its text, and its code, as long as the text, with comments and strings blotted out."""

    def __init__(self, text):
        self.text = text
        blot = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\])\'|^\s*#(?:[^\n]*\\\n)*[^\n]*',
                          re.S | re.M)

        def blotted(found):
            kept = found[0]
            if kept.startswith(('"', "'")):
                return kept[0] + "s" * (len(kept) - 2) + kept[0]
            return re.sub(r"[^\n]", "\x02", kept)

        self.code = blot.sub(blotted, text)
        self.lines = [0] + [k.end() for k in re.finditer("\n", text)]
        self.excluded = []
        self.thrown = [(found.start(), closing(self.code, found.end() - 1))
                       for found in re.finditer(r"\bthrow\s+[\w:]+\(", self.code)]
        for found in re.finditer(r"\b(?:Assert\w*|static_assert|DeclException\w*)\(|\benum\b[^;{]*\{|\boperator\b[^\w\s(]+|"
                                 r"\bconstexpr\b[^;{(=]*|\btemplate <|\bcase\b[^:]*:|\busing\b[^;]*;|\bextern \"", self.code):
            end = found.end()
            if found[0].endswith(("(", "{")):
                end = closing(self.code, end - 1)
            elif found[0].startswith("constexpr"):
                end = self.code.find(";", end)
            self.excluded.append((found.start(), max(end, found.end())))

    def line(self, at):
        return bisect.bisect_right(self.lines, at)

    def is_excluded(self, begin, end):
        return any(a < end and begin < b for a, b in self.excluded) or "\x02" in self.code[begin:end]

    def expression(self, at):
        """The expression round a place, up to a comma, an assignment, a bracket, or None if it is none."""
        code, depth, begin = self.code, 0, at
        while begin > 0:
            here, two = code[begin - 1], code[max(0, begin - 2):begin]
            depth += (here in ")]}") - (here in "([{")
            if depth < 0 or (depth == 0 and (here in ",;{}" or two in ("? ", ": ", "= ", "&&", "||", "<<"))):
                break
            if depth == 0 and re.search(r"\b(return|case|else|throw|do)\s$", code[max(0, begin - 8):begin]):
                break
            begin -= 1
        if begin > 0 and code[begin - 1] in ";{}":
            if not re.search(r"\bfor \([^(){}]*;$", code[max(0, begin - 200):begin]):
                return None
        if re.search(r"[<>=!]= $", code[max(0, begin - 3):begin]):
            return None
        depth, end = 0, at
        while end < len(code):
            here = code[end]
            depth += (here in "([{") - (here in ")]}")
            if depth < 0 or (depth == 0 and (here in ",;}" or code[end:end + 2] in ("? ", ": ", "&&", "||", "<<", "= "))):
                if code[end:end + 2] == "= " and code[end - 1] in "<>=!":
                    end += 1
                    continue
                break
            end += 1
        found = code[begin:end]
        begin, end = begin + len(found) - len(found.lstrip()), end - len(found) + len(found.rstrip())
        found = code[begin:end]
        return None if re.search(r"[{};]|\[[&=]|\[this|\]\(|\bconst\b|\bauto\b", found) or not found else (begin, end)


def once(text):
    """A text on one line, so that the lines of a file stay where they are."""
    return re.sub(r"\s*\n\s*", " ", text)


def chosen(changed, original):
    return f"(rolling_contact_mutant(@) ? ({once(changed)}) : ({original}))"


def replaced(source, at, end, new):
    """A change within an expression: it is written twice."""
    place = source.expression(at)
    if place is None:
        return None
    begin, stop = place
    old = source.text[begin:stop]
    return [(begin, stop, chosen(source.text[begin:at] + new + source.text[end:stop], old))]


def texts(source, draw, kind):
    for found in re.finditer(r'"s*"(?:\s+"s*")*', source.code):
        text = source.text[found.start():found.end()]
        changes = []
        if any(a < found.start() < b for a, b in source.thrown):  # as messages of asserts
            continue
        if kind == "unit":
            for unit in re.finditer(r"(?<=[ (\[/_])(%|[A-Za-z]+2?)(?=[ ),.\]/;:^\"_])", text):
                before = text[:unit.start()]
                if unit[0] in UNITS and (unit.end() == len(text) - 1 or before[-1] in "([/" or before.strip('" ') == ""
                                         or re.search(r"[a-z]{3}_$", before)):
                    changes.append((unit, UNITS[unit[0]]))
        elif " " in text or "_" in text:
            for one, other in [*WORDS, *[(b, a) for a, b in WORDS]]:
                changes += [(word, other) for word in re.finditer(rf"(?<![A-Za-z]){one}(?![A-Za-z])", text)]
        if changes:
            word, other = draw.choice(sorted(changes, key=lambda change: (change[0].start(), change[1])))
            changed = text[:word.start()] + other + text[word.end():]
            yield found.start(), once(text), once(changed), [(found.start(), found.end(), chosen(changed, text))]


def numbers(source, draw, factors):
    for found in re.finditer(r"(?<![\w.\"'\[<])(\d+\.?\d*(?:e[+-]?\d+)?)(?![\w.\"'>]|\])", source.code):
        text = found[1]
        factor = re.fullmatch(FACTOR, text) is not None
        if factor != factors or (0. < float(text) < 1e-8):  # a tolerance, of which a factor is not seen
            continue
        if factors:
            new = {"180": "360", "360": "180"}.get(text.rstrip("."), f"{float(text) * draw.choice([1e-3, 1e3]):.17g}")
            new = repr(float(new)) if "." in text or "e" in text else str(max(1, round(float(new))))
        elif text.isdigit():
            new = str(int(text) + (draw.choice([-1, 1]) if int(text) > 0 else 1))
        else:
            new = repr(float(text) * draw.choice([2., 10.])) if float(text) else "1."
        yield found.start(), text, new, [(found.start(), found.end(), chosen(new, text))]


def signs(source, draw):
    for found in re.finditer(r"(?<=[\w)\]] )[+-](?=\s)|(?<=[(,=] )-(?=[\w(])|(?<=\()-(?=[\w(])|(?<=return )-(?=[\w(])", source.code):
        at, old = found.start(), found[0]
        if '"' in source.code[source.lines[source.line(at) - 1]:].split("\n", 1)[0]:  # of texts
            continue
        binary = source.code[at + 1] in " \n"
        if binary:
            yield at, old, "-" if old == "+" else "+", [(at, at + 1, f"{old} (rolling_contact_mutant(@) ? -1 : 1) *")]
        else:
            yield at, "-", "", [(at, at + 1, "(rolling_contact_mutant(@) ? 1 : -1) * ")]


def comparisons(source, draw):
    beside = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
    turned = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "!=", "!=": "=="}
    for found in re.finditer(r"(?<=[\w)\]] )(<=?|>=?|==|!=)(?=\s)", source.code):
        line = source.code[source.lines[source.line(found.start()) - 1]:found.start()]
        # off by one in a loop; elsewhere most are of real numbers, which are hardly ever equal
        new = (beside if "for (" in line else turned)[found[1]]
        yield found.start(), found[1], new, replaced(source, found.start(), found.end(), new)


def indices(source, draw):
    for found in re.finditer(r"(?<=[\w\])])\[(\w+(?: [+-] \w+)?)\]", source.code):
        old = found[1]
        new = str(1 - int(old)) if old in "01" else str(int(old) - 1) if old.isdigit() else \
            re.sub(r" [+-] 1$", "", old) if re.search(r" [+-] 1$", old) else f"{old} + 1"
        yield found.start(), f"[{old}]", f"[{new}]", [(found.start(1), found.end(1), chosen(new, old))]


def arguments(source, draw):
    for found in re.finditer(r"(\w+)\((?=\w)", source.code):
        if found[1] in SYMMETRIC:
            continue
        end = closing(source.code, found.end() - 1)
        inside = source.code[found.end():end]
        pairs = [pair for pair in re.finditer(rf"(?<![^\s,])({NAME}),\s+(?=({NAME})(?:,|$))", inside)
                 if pair[1] != pair[2] and re.match(r"[a-zA-Z]", pair[1]) and re.match(r"[a-zA-Z]", pair[2])]
        if "(" not in re.sub(r"\(\)", "", inside) and pairs and "{" not in inside:
            pair = draw.choice(pairs)
            one, other = pair[1], pair[2]
            begin = found.end() + pair.start()
            yield (begin, f"{found[1]}(... {one}, {other} ...)", f"{other}, {one}",
                   [(begin, begin + len(one), chosen(other, one)),
                    (found.end() + pair.start(2), found.end() + pair.end(2), chosen(one, other))])


def functions(source, draw):
    for one, other in [*FUNCTIONS, *[(b, a) for a, b in FUNCTIONS if b != "("]]:
        for found in re.finditer(re.escape(one) + (r"\b" if one[-1].isalpha() else ""), source.code):
            if one in (" * ", " / ", " && ", " || "):
                if draw.random() > 0.2:  # there are many of them
                    continue
            if one in (" && ", " || "):
                place = re.search(r"\bif \($", source.code[:source.code.rfind("(", 0, found.start()) + 1])
                begin = source.code.rfind("(", 0, found.start())
                if not place or closing(source.code, begin) < found.start():
                    continue
                begin, end = begin + 1, closing(source.code, begin)
                if re.search(r"[{};=]", source.code[begin:end].replace("==", "").replace("<=", "").replace(">=", "")):
                    continue
                old = source.text[begin:end]
                edits = [(begin, end, chosen(source.text[begin:found.start()] + other + source.text[found.end():end], old))]
            else:
                edits = replaced(source, found.start(), found.end(), other)
            yield found.start(), one, other, edits


def conditions(source, draw):
    for found in re.finditer(r"\b(?:if|while) \(", source.code):
        begin, end = found.end(), closing(source.code, found.end() - 1)
        inside = source.code[begin:end]
        if re.search(r"[;{]|[^<>=!]=[^=]", inside):
            continue
        yield (begin, once(source.text[begin:end]), f"!({once(source.text[begin:end])})",
               [(begin, end, f"rolling_contact_mutant(@) != static_cast<bool>({source.text[begin:end]})")])


def assignments(source, draw):
    for found in re.finditer(r"(?<=[;{}])\s*([\w.\->\[\]()]+\s+[-+*/]?=(?!=)[^;{}]*;)", source.code):
        begin, end = found.start(1), found.end(1)
        old = source.text[begin:end]
        if "[&" not in old and not old.startswith(("return", "using", "namespace")):
            yield begin, once(old), "", [(begin, end, f"{{ if (!rolling_contact_mutant(@)) {old} }}")]


OPERATORS = {"unit in text": lambda s, d: texts(s, d, "unit"), "word in text": lambda s, d: texts(s, d, "word"),
             "unit factor": lambda s, d: numbers(s, d, True), "constant": lambda s, d: numbers(s, d, False), "sign": signs,
             "comparison": comparisons, "index": indices, "arguments": arguments, "function": functions,
             "condition": conditions, "assignment": assignments}


def candidates(source, operator, draw):
    """All mutations of a file by an operator: place, original, changed, edits."""
    for at, old, new, edits in OPERATORS[operator](source, draw):
        if edits and not source.is_excluded(min(e[0] for e in edits), max(e[1] for e in edits)):
            yield at, old, new, edits


def draw_all(project, rooms, count, seed, first, refused, taken):
    """Mutations of all rooms, each at least twice, by all operators.

    refused: (file, line, operator) that did not compile; taken: edits of each file that others have."""
    draw = random.Random(f"mutations {seed}")
    sources = {room: {path: Source(path.read_text()) for path in sorted((project / "source" / room).glob("*.cc"))}
               for room in rooms}
    sizes = [sum(len(source.lines) for source in sources[room].values()) for room in rooms]
    each = min(2, count // len(rooms))
    places = rooms * each + draw.choices(rooms, sizes, k=count - each * len(rooms))
    operators = [operator for operator, share in SHARES.items() for _ in range(round(share * count / 60 + 0.49))]
    draw.shuffle(operators)
    draw.shuffle(places)
    mutants = []
    for k, room in enumerate(places):
        local = random.Random(f"mutation {seed} {k}")  # what is refused changes no other one
        for operator in [operators[k], *local.sample(sorted(SHARES), len(SHARES))]:
            found = [(operator, path, *candidate) for path, source in sources[room].items()
                     for candidate in candidates(source, operator, random.Random(f"{seed} {path.name} {operator}"))]
            local.shuffle(found)
            one = next((one for one in found if is_free(one, sources[room], taken)), None)
            if one:
                break
        if not one:
            continue
        if is_refused(one, sources[room], refused):  # another one of the file, so that no other file is compiled again
            path = one[1]
            others = [(other, path, *candidate) for other in [operator, *sorted(SHARES)]
                      for candidate in candidates(sources[room][path], other, random.Random(f"{seed} {path.name} {other}"))]
            local.shuffle(others)
            others.sort(key=lambda other: other[0] != operator)
            one = next((other for other in others if is_free(other, sources[room], taken)
                        and not is_refused(other, sources[room], refused)), None)
            if not one:
                continue
        operator, path, at, old, new, edits = one
        begin, end = min(e[0] for e in edits), max(e[1] for e in edits)
        taken.setdefault(path, []).append((begin, end))
        mutants.append({"number": first + k, "seed": seed, "room": room, "file": str(path.relative_to(project)),
                        "line": sources[room][path].line(at), "last": sources[room][path].line(end),
                        "operator": operator, "original": old, "changed": new, "edits": edits})
    return mutants


def is_refused(mutant, sources, refused):
    operator, path, at = mutant[:3]
    return (path.name, sources[path].line(at), operator) in refused


def is_free(mutant, sources, taken):
    path, edits = mutant[1], mutant[5]
    begin, end = min(e[0] for e in edits) - 40, max(e[1] for e in edits) + 40
    return not any(a < end and begin < b for a, b in taken.get(path, []))


def written(text, mutants, header):
    """The text of a file with its mutations."""
    edits = [(begin, end, new.replace("@", str(mutant["number"]))) for mutant in mutants for begin, end, new in mutant["edits"]]
    for begin, end, new in sorted(edits, reverse=True):
        text = text[:begin] + new + text[end:]
    return f'#include "{header}"\n#line 1\n' + text
