"""The one kind of failure the report tells its user about."""

BAD_USAGE = 2
BAD_FILE = 4


class ReportError(Exception):
    """A one-line message that names what is wrong and where, and the exit code to leave with."""

    def __init__(self, message, code=BAD_FILE):
        super().__init__(" ".join(str(message).split()))
        self.code = code
