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
    schema = {"$ref": f"#/$defs/{definition}", "$defs": definitions}
    return [f"{error.json_path}: {error.message[:300]}" for error in jsonschema.Draft202012Validator(schema).iter_errors(document)]
