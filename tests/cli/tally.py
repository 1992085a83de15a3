"""What the tests of documents share: they count what holds, and validate JSON documents by a schema."""

try:
    import jsonschema
except ImportError:
    jsonschema = None


class Tally:
    passed = failed = 0

    def tell(self, what, wrong=None):
        """Counts, and prints what is wrong."""
        if wrong:
            self.failed += 1
            print(f"FAILED: {what}\n  {wrong}")
        else:
            self.passed += 1

    def end(self, advice=""):
        """Prints the counts. Returned: the exit status."""
        print(f"{self.passed} passed, {self.failed} failed" + (advice if self.failed else ""))
        return int(self.failed > 0)


def errors(definitions, definition, document):
    """What of a document is not as a definition of a JSON Schema says."""
    return [f"{error.json_path}: {error.message[:300]}" for error in found(definitions, definition, document)]


def has_error(definitions, definition, document):
    """The same up to the first error. Names of keys, which take little time, are compared before values."""
    names = ("required", "additionalProperties")
    parts = definitions[definition]
    ordered = {key: parts[key] for key in sorted(parts, key=lambda key: key not in names)}
    return any(True for _ in found({**definitions, definition: ordered}, definition, document))


def found(definitions, definition, document):
    return jsonschema.Draft202012Validator({"$ref": f"#/$defs/{definition}", "$defs": definitions}).iter_errors(document)
