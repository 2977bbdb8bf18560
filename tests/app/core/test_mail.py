"""Mails as other programs read them."""

from email import message_from_bytes, policy

from aiosmtplib.email import flatten_message

from app.core.mail import build_mail


def test_the_address_that_stops_mails_stands_on_one_line_as_it_is():
    # RFC 8058, 3.1: a URI in angle brackets. Mail programs decode no encoded words there.
    url = "https://sounds.example/v1/mail-choices/" + "aB3_-" * 40 + "/stop"
    message = build_mail(
        sender="Soundlist <soundlist@sounds.example>",
        recipient="ada@studio.example",
        subject="Schüsse und Türen",
        text="Grüße",
        stop_url=url,
    )
    head = flatten_message(message).partition(b"\r\n\r\n")[0].decode("ascii")
    lines = head.split("\r\n")
    assert f"List-Unsubscribe: <{url}>" in lines
    assert "List-Unsubscribe-Post: List-Unsubscribe=One-Click" in lines
    assert max(len(line) for line in lines if not line.startswith("List-")) <= 78
    read = message_from_bytes(flatten_message(message), policy=policy.default)
    assert read["Subject"] == "Schüsse und Türen"
