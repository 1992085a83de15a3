"""Reads C source as tokens, and lists small edits of the kind of typical programming errors."""

import collections
import hashlib
import re

TOKEN = re.compile(r"""
    (?P<space>\s+)
  | (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<directive>\#(?:\\\n|/\*.*?\*/|[^\n])*)
  | (?P<text>(?:u8|[LuU])?(?:"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'))
  | (?P<number>\.?\d(?:[eEpP][+-]|[\w.])*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<mark>\.\.\.|<<=|>>=|->|\+\+|--|<=|>=|==|!=|&&|\|\||<<|>>|[-+*/%&|^]=|[^\s\w])
""", re.VERBOSE | re.DOTALL)

Token = collections.namedtuple("Token", "kind text start end")
INTEGER, FLOAT = re.compile(r"(\d+)([uUlL]*)"), re.compile(r"\d*\.\d+(?:[eE][+-]?\d+)?|\d+\.(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+")

KINDS = ("comparison", "bound", "arithmetic", "logic", "constant", "status", "condition", "deletion", "swap")
HEADS = {"if", "while", "for", "switch"}
NOT_DELETED = HEADS | {"else", "do", "case", "default", "typedef", "struct", "union", "enum", "static", "extern"}
NOT_CALLED = HEADS | {"return", "sizeof", "case", "do", "else"}

COMPARISONS = {"<": ("<=", ">"), "<=": ("<", ">"), ">": (">=", "<"), ">=": (">", "<"), "==": ("!=",), "!=": ("==",)}
BINARY = {"+": ("-",), "-": ("+",), "*": ("/",), "/": ("*",), "%": ("/",)}
ASSIGNED = {"+=": ("-=", "="), "-=": ("+=", "="), "*=": ("/=", "="), "/=": ("*=", "="), "++": ("--",), "--": ("++",)}
LOGIC = {"&&": ("||",), "||": ("&&",)}
BITS = {"&": ("|",), "|": ("&",)}
NAMED = {"true": ("false",), "false": ("true",), "INFINITY": ("0.0",), "NAN": ("0.0",)}


def tokens_of(source):
    """The tokens of the compiler, without comments and preprocessor directives."""
    found, place = [], 0
    while place < len(source):
        match = TOKEN.match(source, place)
        if not match:
            raise ValueError(f"byte {place} begins no token of C")
        if match.lastgroup not in ("space", "comment", "directive"):
            found.append(Token(match.lastgroup, match.group(), match.start(), match.end()))
        place = match.end()
    return found


class Edit(collections.namedtuple("Edit", "file function line becomes nth kind start end new")):
    """One edit of a file: `new` replaces the text between two offsets. An edit is identified by its file, its function,
    the text of its lines before and after the edit, and its number among equal lines; not by its position."""

    @property
    def name(self):
        words = "\0".join((self.file, self.function, self.line, self.becomes, str(self.nth)))
        return hashlib.sha256(words.encode()).hexdigest()[:10]

    def applied(self, source):
        return source[:self.start] + self.new + source[self.end:]


class Source:
    """The tokens of a file, with matching brackets and the function of each token."""

    def __init__(self, text):
        self.text, self.tokens = text, tokens_of(text)
        count = len(self.tokens)
        self.pair, self.inside, self.function = {}, [None] * count, [""] * count
        opened, function = [], ""
        for k, token in enumerate(self.tokens):
            if token.kind == "mark" and token.text in ")]}" and opened:
                first = opened.pop()
                self.pair[first], self.pair[k] = k, first
            self.inside[k] = opened[-1] if opened else None
            if token.kind == "mark" and token.text in "([{":
                if not opened:
                    function = self.begun(k) if token.text == "{" else ""
                opened.append(k)
            self.function[k] = function if opened or token.text == "}" else ""

    def begun(self, k):
        """The name of the function whose body this brace opens; "" if it opens none."""
        if self.is_mark(k - 1, ")"):
            first = self.pair.get(k - 1)
            if first and self.tokens[first - 1].kind == "word":
                return self.tokens[first - 1].text
        return ""

    def is_mark(self, k, text):
        return 0 <= k < len(self.tokens) and self.tokens[k].kind == "mark" and self.tokens[k].text == text

    def word(self, k):
        return self.tokens[k].text if 0 <= k < len(self.tokens) and self.tokens[k].kind == "word" else ""

    def is_binary(self, k):
        """Whether the token before this operator can end an operand."""
        if k == 0:
            return False
        before = self.tokens[k - 1]
        if before.kind == "mark":
            return before.text in ")]"
        return before.text not in ("return", "case", "sizeof", "else", "do")

    def span(self, first, last):
        return self.text[self.tokens[first].start:self.tokens[last].end]

    def parts(self, first, mark):
        """The parts of a bracket between commas or semicolons, each as its first and last token."""
        found, begin = [], first + 1
        for k in range(first + 1, self.pair[first] + 1):
            if k == self.pair[first] or (self.inside[k] == first and self.is_mark(k, mark)):
                found.append((begin, k - 1))
                begin = k + 1
        return found


def loop_bounds(source):
    """Edits that shift the first or last value of a loop by one. Returns them with the tokens that they concern."""
    changes, taken = [], set()
    for k, token in enumerate(source.tokens):
        if token.text != "for" or token.kind != "word" or k + 1 not in source.pair:
            continue
        parts = source.parts(k + 1, ";")
        if len(parts) != 3:
            continue
        for j in range(parts[0][0], parts[0][1] + 1):
            if source.is_mark(j, "=") and source.tokens[j + 1].text == "0":
                changes.append((source.tokens[j + 1].start, source.tokens[j + 1].end, "1"))
                taken.add(j + 1)
        for j in range(parts[1][0], parts[1][1] + 1):
            relation = source.tokens[j]
            if relation.kind == "mark" and relation.text in ("<", "<=", ">", ">="):
                changes.append((relation.start, relation.end, COMPARISONS[relation.text][0]))
                changes.append((relation.start, relation.start, "+ 1 " if relation.text[0] == "<" else "- 1 "))
                taken.add(j)
    return changes, taken


def constants(token):
    """Values that may replace a constant."""
    if token.kind == "word":
        return NAMED.get(token.text, ())
    whole = INTEGER.fullmatch(token.text)
    if whole and (whole.group(1) == "0" or whole.group(1)[0] != "0"):
        value = int(whole.group(1))
        return [f"{other}{whole.group(2)}" for other in (value + 1, value - 1) if other >= 0]
    if FLOAT.fullmatch(token.text):
        return (f"(2.0 * {token.text})", f"(0.5 * {token.text})") if float(token.text) else ("1.0",)
    return ()


def one_token(source, taken, statuses):
    """Edits that replace one token, as (kind, start, end, new)."""
    for k, token in enumerate(source.tokens):
        if k in taken:
            continue
        found = []
        if token.kind == "mark":
            found += [("comparison", new) for new in COMPARISONS.get(token.text, ())]
            found += [("logic", new) for new in LOGIC.get(token.text, ())]
            found += [("arithmetic", new) for new in ASSIGNED.get(token.text, ())]
            if source.is_binary(k):
                found += [("arithmetic", new) for new in BINARY.get(token.text, ())]
                found += [("logic", new) for new in BITS.get(token.text, ())]
            elif token.text == "-":
                found.append(("arithmetic", ""))
            if token.text in "!~":
                found.append(("logic", ""))
        elif token.kind == "word" and token.text in statuses:
            # success and the next two statuses of the list
            place = statuses.index(token.text)
            others = {statuses[0], statuses[(place + 1) % len(statuses)], statuses[(place + 2) % len(statuses)]}
            found += [("status", new) for new in sorted(others - {token.text})]
        else:
            found += [("constant", new) for new in constants(token)]
        for kind, new in found:
            yield kind, token.start, token.end, new


def conditions(source):
    """Edits that negate a condition: of `if`, of `while`, and before a question mark."""
    for k in range(len(source.tokens)):
        if source.word(k) in ("if", "while") and k + 1 in source.pair:
            first, last = k + 2, source.pair[k + 1] - 1
        elif source.is_mark(k, "?"):
            first, last = k, k - 1
            while first - 1 >= 0 and not ends_condition(source, first - 1, source.inside[k]):
                first = source.pair[first - 1] if first - 1 in source.pair else first - 1
        else:
            continue
        if first <= last:
            yield source.tokens[first].start, source.tokens[last].end, f"!({source.span(first, last)})"


def ends_condition(source, k, inside):
    """Whether a token before a question mark is outside its condition."""
    return k == inside or source.word(k) == "return" or (
        source.tokens[k].kind == "mark" and source.tokens[k].text in
        ("=", ",", ";", "{", "}", "?", ":", "+=", "-=", "*=", "/=", "|=", "&="))


def deletions(source):
    """Edits that delete a statement."""
    for k in range(1, len(source.tokens)):
        inside = source.inside[k]
        if inside is None or not source.is_mark(inside, "{") or not begins_statement(source, k):
            continue
        if source.word(k) in NOT_DELETED or source.tokens[k].text in ";{}":
            continue
        for j in range(k, source.pair.get(inside, k)):
            if source.inside[j] == inside and source.is_mark(j, ";"):
                yield source.tokens[k].start, source.tokens[j].end, ";"
                break


def begins_statement(source, k):
    before = k - 1
    if source.word(before) in ("else", "do"):
        return True
    if source.is_mark(before, ")") and before in source.pair:
        return source.word(source.pair[before] - 1) in HEADS
    if source.is_mark(before, ":"):  # of a label, not of a conditional expression
        return source.word(before - 1) == "default" or source.word(before - 2) == "case" or \
            source.tokens[before - 2].text in (";", "{", "}")
    return source.tokens[before].kind == "mark" and source.tokens[before].text in ";{}"


def swaps(source):
    """Edits that exchange neighbouring arguments of a call."""
    for k in range(1, len(source.tokens)):
        if not source.is_mark(k, "(") or not source.word(k - 1) or source.word(k - 1) in NOT_CALLED or \
                source.inside[k] is None or k not in source.pair:
            continue
        parts = source.parts(k, ",")
        for (a, b), (c, d) in zip(parts, parts[1:]):
            if a <= b and c <= d and source.span(a, b) != source.span(c, d):
                between = source.text[source.tokens[b].end:source.tokens[c].start]
                yield (source.tokens[a].start, source.tokens[d].end,
                       source.span(c, d) + between + source.span(a, b))


def edits_of(file, text, statuses):
    """All edits of a file, in the order of its text. `statuses`: the names of all statuses, success first."""
    source = Source(text)
    bounds, taken = loop_bounds(source)
    found = [("bound", *change) for change in bounds]
    found += one_token(source, taken, statuses)
    for kind, changes in (("condition", conditions), ("deletion", deletions), ("swap", swaps)):
        found += [(kind, *change) for change in changes(source)]
    starts = [token.start for token in source.tokens]
    function_at = dict(zip(starts, source.function))
    edits, seen = [], collections.Counter()
    for kind, start, end, new in sorted(found, key=lambda change: (change[1], change[2], change[0], change[3])):
        first = text.rfind("\n", 0, start) + 1
        last = text.find("\n", end)
        last = len(text) if last < 0 else last
        line = " ".join(text[first:last].split())
        becomes = " ".join((text[first:start] + new + text[end:last]).split())
        key = (function_at[start], line, becomes)
        seen[key] += 1
        edits.append(Edit(file, *key, seen[key], kind, start, end, new))
    return edits
