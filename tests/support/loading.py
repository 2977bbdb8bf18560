"""What a call in a sandbox had to load before it could run: nothing, where the server has rehearsed it."""

from typing import Any

from audio_checks import Sandbox

CODE = """(lambda before, call: (call(), sorted(set(__import__("sys").modules) - before))[1])(
    set(__import__("sys").modules),
    lambda: getattr(__import__("importlib").import_module({module!r}), {name!r})({given}),
)"""


def modules_loaded(sandbox: Sandbox, module: str, name: str, *arguments: Any, **options: Any) -> list[str]:
    """Return the modules that a child loads to call a function with arguments that can be written down."""
    given = [repr(argument) for argument in arguments] + [f"{key}={value!r}" for key, value in options.items()]
    code = CODE.format(module=module, name=name, given=", ".join(given)).replace("\n", " ")
    with sandbox.child(reads=[arguments[0]], writes=arguments[1:]) as child:
        return list(child.call(eval, code))
