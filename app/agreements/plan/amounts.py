"""The sharing of an amount in whole minor units."""

from collections.abc import Sequence

from app.agreements.errors import NothingToSplit


def split(amount_minor: int, weights: Sequence[int]) -> list[int]:
    """Split an amount over parts by their weights, equally where none has any; the parts add up to the amount.

    What is left after rounding down goes to the largest remainders, the earlier part first where they are alike.
    """
    if amount_minor < 0 or any(weight < 0 for weight in weights):
        raise ValueError("only amounts and weights of zero or more are split")
    if not weights:
        raise NothingToSplit(
            f"{amount_minor} cannot be split over no cues",
            fix="the studio recalls the contract and puts cues into the milestone",
        )
    if not any(weights):
        weights = [1] * len(weights)
    whole = sum(weights)
    parts = [divmod(amount_minor * weight, whole) for weight in weights]
    left = amount_minor - sum(part for part, _ in parts)
    by_remainder = sorted(range(len(parts)), key=lambda index: -parts[index][1])
    lucky = set(by_remainder[:left])
    return [part + (index in lucky) for index, (part, _) in enumerate(parts)]
