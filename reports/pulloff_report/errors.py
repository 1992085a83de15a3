"""The exception for errors that the report prints for its user."""

BAD_USAGE = 2
BAD_FILE = 4


class ReportError(Exception):
    """An error with a one-line message, which names the file and the fault, and an exit code."""

    def __init__(self, message, code=BAD_FILE):
        super().__init__(" ".join(str(message).split()))
        self.code = code
