"""A few processes that live and stop together."""

import signal
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from types import FrameType

STOP_WITHIN_S = 20.0
WATCH_EVERY_S = 0.2


class ProcessTree:
    """Commands of `soundlist` that run together; each stops by itself once this process is gone, however it ended."""

    def __init__(self, commands: Mapping[str, Sequence[str]], environment: Mapping[str, str]) -> None:
        self._commands = commands
        self._environment = environment
        self._processes: dict[str, subprocess.Popen[bytes]] = {}
        self._stopping = False

    def start(self, kept_open: Sequence[int]) -> None:
        """Start every command, each in a new session so that Ctrl-C is handled once, here.

        Their standard input is a pipe that closes with this process. They keep these descriptors open until they end.
        """
        for name, command in self._commands.items():
            self._processes[name] = subprocess.Popen(
                [sys.executable, "-m", "app", *command, "--stop-with-input"],
                env=self._environment,
                stdin=subprocess.PIPE,
                pass_fds=kept_open,
                start_new_session=True,
            )

    @property
    def process_ids(self) -> list[int]:
        """The ids of the processes that were started."""
        return [process.pid for process in self._processes.values()]

    def is_stopping(self) -> bool:
        """Whether a stop was requested."""
        return self._stopping

    def is_whole(self) -> bool:
        """Whether every process is running and no stop was requested."""
        return not self._stopping and all(process.poll() is None for process in self._processes.values())

    def ended(self) -> str:
        """Return the processes that ended by themselves, in words."""
        codes = {name: process.poll() for name, process in self._processes.items()}
        return " and ".join(f"the {name} ended with code {code}" for name, code in codes.items() if code is not None)

    def wait_until(self, condition: Callable[[], bool]) -> bool:
        """Return True once the condition holds, False when a process ended or a stop was requested."""
        while self.is_whole():
            if condition():
                return True
            time.sleep(WATCH_EVERY_S)
        return False

    def watch(self) -> int:
        """Return 0 once stopped by a signal, or the exit code of the process that died."""
        while self.is_whole():
            time.sleep(WATCH_EVERY_S)
        died = [process.returncode for process in self._processes.values() if process.returncode]
        return 0 if self._stopping or not died else died[0]

    def stop_on_signal(self, _signal: int, _frame: FrameType | None) -> None:
        """Begin to stop; the watching loop does the rest."""
        self._stopping = True

    def stop(self) -> None:
        """Stop every process, the last started first; kill what does not stop in time."""
        processes = list(reversed(self._processes.values()))
        for process in processes:
            if process.poll() is None:
                process.send_signal(signal.SIGTERM)
        deadline = time.monotonic() + STOP_WITHIN_S
        for process in processes:
            try:
                process.wait(max(0.1, deadline - time.monotonic()))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
