"""The meaning of the heads of columns in people's sound lists."""

import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

HEADS: Mapping[str, str] = {
    "number": "number|no|nr|num|id|cue|cue no|cue nr|cue number|cue id|sound id|sound no|sound number|asset id|"
    "asset number|sfx id|item|item no|ref|reference id|nummer|lfd nr|soundnummer|sound nr|kennung|numero|núm|n°|"
    "番号|通し番号|管理番号"
    "|编号|序号|編號|번호|номер|lp|código",
    "name": "name|sound|title|cue name|sound name|sound title|sound effect|sound effect name|sound effects|effect|"
    "effect name|asset|asset name|audio asset|audio name|sound asset|sfx|sfx name|sounds|audio|item name|audio cue|"
    "sound cue|titel|bezeichnung|klang|klangname|geräusch|sound bezeichnung|nom|nom du son|son|titre|nombre|"
    "nombre del sonido|sonido|título|efecto|名前|名称|サウンド|サウンド名|音名|効果音|効果音名|se名|音声名|タイトル"
    "|音效|音效名|音效名称|音效名稱|声音名称|声音|名稱|이름|사운드|사운드명|효과음|название|имя|звук|название звука"
    "|nazwa|nazwa dźwięku|dźwięk|nome|nome do som|som|nome del suono|suono|titolo|naam|geluid",
    "file_name": "filename|file|wav|file name|wav name|wav file|asset file|audio file|audio filename|audio file name|"
    "sound file|sound filename|sound file name|target file|target filename|final file name|export name|dateiname|"
    "datei|audiodatei|fichier|nom de fichier|nom du fichier|fichier audio|archivo|nombre de archivo|"
    "nombre del archivo|nombre archivo|fichero|wav datei|asset path|file path|path|dateipfad|pfad|"
    "ファイル名|ファイル|音声ファイル|サウンドファイル"
    "|文件名|文件|音频文件|檔名|檔案名稱|파일명|파일|파일 이름|имя файла|файл|nazwa pliku|plik|nome do arquivo|arquivo"
    "|nome do ficheiro|ficheiro|nome file|nome del file|bestandsnaam|bestand",
    "category": "category|type|class|group|sound type|sound category|asset type|audio type|kategorie|gruppe|art|"
    "categorie|categoria|catégorie|categoría|groupe|grupo|tipo|kind|sound kind|kind of sound|sfx type|sfx category|"
    "typ|soundtyp|klangart|sorte|bus|カテゴリ|カテゴリー|種別|分類|種類|グループ"
    "|类别|分类|类型|類別|類型|카테고리|분류|종류|категория|тип|группа|kategoria|rodzaj|grupa|categoria do som|gruppo"
    "|categorie geluid|soort",
    "description": "description|desc|descr|details|detail|brief|sound description|what it is|short description|"
    "what we hear|"
    "beschreibung|kurzbeschreibung|descripcion|descripción|détails|detalles|説明|内容|詳細|概要"
    "|描述|说明|備註說明|설명|описание|opis|descrição|descrizione|omschrijving|beschrijving",
    "use": "use|usage|context|use in game|use in the game|used in|used for|in game use|ingame use|verwendung|einsatz|"
    "kontext|where used|where|used where|scene|szene|verwendet in|einsatzort|wo|utilisation|usage en jeu|contexte|"
    "uso|uso en el juego|contexto|escena|scène|用途|使用場所|使用箇所|シーン|場面"
    "|用处|使用场景|场景|용도|использование|сцена|zastosowanie|scena|utilização|cena|utilizzo|gebruik",
    "trigger": "trigger|event|when|triggered by|trigger event|game event|event name|auslöser|"
    "ereignis|ausgelöst durch|played when|played on|wann|déclencheur|événement|disparador|evento|cuándo|"
    "トリガー|イベント|再生タイミング|タイミング"
    "|触发|触发条件|事件|觸發|트리거|이벤트|событие|триггер|zdarzenie|wyzwalacz|gatilho|attivazione",
    "duration_s": "duration|length|len|requested duration|requested length|target length|target duration|"
    "sound length|sound duration|dauer|länge|laenge|duree|durée|longueur|"
    "duracion|duración|longitud|dur|length approx|approx length|time|zeit|laufzeit|spieldauer|longitud aprox|"
    "長さ|尺|時間|再生時間|秒数|長さ秒"
    "|时长|长度|時長|長度|길이|재생 시간|длительность|длина|продолжительность|czas trwania|długość|czas|duração"
    "|comprimento|tempo di durata|durata|lunghezza|duur|lengte",
    "duration_min_s": "shortest length|mindestlänge",
    "duration_max_s": "longest length|höchstlänge",
    "length_locked": "locked|length locked|locked length|fixed length|exact length|duration locked|länge fest|"
    "長さ固定|尺固定",
    "frame_rate_fps": "fps|frame rate|framerate|bildrate|フレームレート",
    "loop": "loop|looping|looped|loops|is loop|is looping|is looped|loopable|is loopable|loop one shot|loop oneshot|"
    "loop or one shot|one shot or loop|loop flag|can loop|should loop|needs loop|needs to loop|seamless loop|"
    "loop yes no|loop y n|does it loop|schleife|loop j n|loop ja nein|geloopt|loopbar|endlos|boucle|en boucle|"
    "bouclé|bucle|en bucle|repetir|ループ|ループ有無|繰り返し"
    "|循环|是否循环|循環|루프|반복|цикл|зацикленный|зациклить|луп|pętla|zapętlony|em loop|ciclo|ciclico|in loop"
    "|lus",
    "reverb": "reverb|reverb tail|hall|reverb type|réverbération|reverberación|リバーブ|残響",
    "channels": "channels|channel|channel count|number of channels|num channels|mono stereo|stereo mono|mono or stereo|"
    "stereo or mono|ch|chs|channel format|channel config|kanäle|kanal|canaux|canales|canali|チャンネル|チャンネル数"
    "|声道|聲道|채널|каналы|kanały|canais|kanalen",
    "variations": "variations|how many|variation|variants|variant|vars|var|count|qty|quantity|num variations|"
    "varianten|variationen|variante|anzahl|files|versions|alternates|alts|round robins|round robin|rr|takes|"
    "anz|stück|dateien|variantes|variaciones|variación|variante|nombre de variations|nb variations|nb de variations|"
    "número de variaciones|cantidad|quantité|バリエーション|バリエーション数|差分|差分数|数|個数|本数|ファイル数"
    "|变体|变体数|变化|数量|變體|變體數|數量|변형|변형 수|개수|вариации|вариаций|варианты|количество|warianty"
    "|liczba wariantów|ilość|wariacje|variações|quantidade|número de variações|variazioni|varianti"
    "|quantità|numero di variazioni|variaties|aantal",
    "state": "state|status|stage|stand|design status|maturity|reife|reifegrad|statut|état|estado|状態|ステータス|進捗"
    "|状态|狀態|상태|статус|состояние|stan|estado atual|stato|toestand",
    "need": "need|needed|need level|moscow|must should wish|must should could|must have|necessity|required|"
    "production priority|bedarf|notwendigkeit|muss soll wunsch|nécessité|besoin|necesidad|必要度|必須度"
    "|必要性|必需|필요도|необходимость|potrzeba|necessidade|necessità|noodzaak",
    "phase": "phase|production phase|project phase|phase of production|needed for phase|produktionsphase|fase|"
    "fase de producción|phase de production|フェーズ|阶段|階段|단계|фаза|faza",
    "playback_priority": "priority|prio|playback priority|playback prio|voice priority|engine priority|importance|"
    "sound priority|priorität|abspielpriorität|wichtigkeit|rang|priorité|prioridad|importancia|優先度|優先順位|重要度"
    "|优先级|優先級|우선순위|приоритет|priorytet|prioridade|priorità|prioriteit",
    "due_on": "due|due date|due on|due by|deadline|needed by|needed on|need by|date due|date needed|delivery date|"
    "target date|milestone date|eta|deliver by|delivery due|required by|fällig|fällig am|fälligkeit|termin|"
    "abgabe|abgabetermin|liefertermin|bis wann|fälligkeitsdatum|lieferdatum|stichtag|échéance|date limite|"
    "date de livraison|date d échéance|livraison|fecha límite|fecha de entrega|entrega|vencimiento|"
    "締切|締め切り|締切日|〆切|納期|納品日|期限|期日"
    "|截止日期|截止|交付日期|截止日|交付日|마감일|마감|납기|납기일|срок|срок сдачи|дедлайн|дата сдачи|termin oddania"
    "|data oddania|prazo|data de entrega|scadenza|data di consegna|consegna|leverdatum|einddatum",
    "placeholder": "placeholder|temp|is placeholder|platzhalter|provisoire|provisional|仮|仮音",
    "palette": "palette|in palette",
    "implementer": "implementer|implemented by|integrator|integrated by|puts it in|audio implementer|eingebaut von|"
    "implementiert von|einbau|intégrateur|実装者|実装担当",
    "recorder": "recorder|recorded by|recordist|records|aufgenommen von|aufnahme|aufnahme von|録音者|録音担当",
}
UNITS: Mapping[str, float] = {
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds", "sek", "sekunde", "sekunden"), 1.0),
    **dict.fromkeys(("seconde", "secondes", "seg", "segs", "segundo", "segundos", "秒", "초"), 1.0),
    **dict.fromkeys(("с", "сек", "секунд", "секунды", "sekund", "sekundy", "secondi", "seconden"), 1.0),
    **dict.fromkeys(("ms", "msec", "msecs", "millisecond", "milliseconds", "millisekunde", "millisekunden"), 0.001),
    **dict.fromkeys(
        ("millis", "millisecondes", "milisegundos", "ミリ秒", "毫秒", "밀리초", "мс", "millisecondi"), 0.001
    ),
    **dict.fromkeys(
        ("min", "mins", "minute", "minutes", "minuten", "minutos", "minuto", "分", "分钟", "분", "мин"), 60.0
    ),
    **dict.fromkeys(("h", "hr", "hrs", "hour", "hours", "std", "stunde", "stunden", "時間"), 3600.0),
}
"""Seconds in a unit of time, by its word."""
COUNTED_UNITS: Mapping[str, str] = {
    **dict.fromkeys(("frame", "frames", "frm", "frms", "bild", "bilder", "images", "フレーム"), "frames"),
    **dict.fromkeys(("sample", "samples", "smp", "smpl", "smpls", "サンプル"), "samples"),
}
"""Units that are a length only at a rate, by their words."""
UNITS_OF_OTHER_THINGS: Mapping[str, str] = {
    **dict.fromkeys(("bar", "bars", "beat", "beats", "takt", "takte", "measure", "measures", "小節"), "musical time"),
    **dict.fromkeys(("tick", "ticks", "tempo", "bpm"), "musical time"),
    **dict.fromkeys(("b", "kb", "mb", "gb", "kib", "mib", "byte", "bytes", "kbyte", "mbyte"), "file size"),
    **dict.fromkeys(("word", "words", "line", "lines", "character", "characters", "chars", "pages"), "text"),
    **dict.fromkeys(("px", "pixel", "pixels", "cm", "mm", "m", "meter", "meters", "metres", "km", "ft"), "distance"),
    **dict.fromkeys(("hz", "khz", "db", "dbfs", "lufs", "percent", "semitones", "day", "days", "week"), "other units"),
    **dict.fromkeys(("weeks", "month", "months", "tage", "wochen"), "other units"),
}


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


CLOCKS = frozenset({"mm ss", "m ss", "hh mm ss", "h mm ss", "min sec", "min s", "mm ss ms", "m s", "hh mm ss ms"})
ABOUT_A_LENGTH = _words(
    "approx approximate approximately max maximum target requested estimated estimate est ca circa total "
    "ideal desired wanted needed of in the sound file audio range final loop clip game as about rough "
    "goal ungefähr etwa unit units"
)
_COUNT_WORDS = _words(
    "number no nr num of the a count qty quantity total needed required how many per anzahl der de des nombre nb"
)
_VARIATION_WORDS = _words(
    "variation variations variant variants var vars alternate alternates alt alts version versions file "
    "files take takes robins varianten variationen variante variaciones variantes"
)
_DUE_WORDS = _words("due deadline needed delivery deliver target date by on when final deliverable day")
MAX_HEADER_CHARS = 200  # what is longer is not a head of ours


@dataclass(frozen=True)
class Head:
    """The content of a column's head: its field, None if unknown, and the unit of its numbers."""

    field: str | None
    unit_s: float = 1.0
    is_ours: bool = False  # written exactly as we export it
    counted: str = ""  # "frames" or "samples", which are a length at a rate only
    note: str = ""  # what was guessed, or why the head is none of a field that it resembles


def plain_head(head: str) -> str:
    """Return the words of a head in lower case without accents, joined by spaces."""
    parted = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", head)  # fileName, as programmers write it
    letters = unicodedata.normalize("NFKD", parted.casefold().replace("ß", "ss"))
    letters = "".join(letter for letter in letters if not unicodedata.combining(letter))
    return " ".join(re.findall(r"[^\W_]+", letters))


def _known_heads() -> dict[str, str]:
    fields_by_head: dict[str, str] = {}
    for field, heads in HEADS.items():
        for head in (field, *heads.split("|")):
            fields_by_head.setdefault(plain_head(head), field)
    return fields_by_head


_FIELD_OF = _known_heads()
_UNITS = {plain_head(word): factor for word, factor in UNITS.items()}
_COUNTED = {plain_head(word): unit for word, unit in COUNTED_UNITS.items()}
_OTHERS = {plain_head(word): what for word, what in UNITS_OF_OTHER_THINGS.items()}


def head_of(text: str) -> Head:
    """Return the meaning of a column's head, whatever its case, brackets, accents and unit."""
    if len(text) > MAX_HEADER_CHARS:
        return Head(None)
    if text.strip() in HEADS:
        return Head(text.strip(), is_ours=True)
    if text.strip() in ("#", "№", "Nº", "N°"):
        return Head("number")
    plain = plain_head(text)
    if not plain:
        return Head(None)
    if field := _FIELD_OF.get(plain):
        return Head(field)
    if plain in _UNITS and len(plain) > 2:  # a column called "Seconds"
        return Head("duration_s", _UNITS[plain])
    words = plain.split()
    if head := _length_with_unit(words):
        return head
    if _VARIATION_WORDS.intersection(words) and set(words) <= _VARIATION_WORDS | _COUNT_WORDS:
        return Head("variations")
    if {"due", "deadline", "needed", "delivery", "deliver"}.intersection(words) and set(words) <= _DUE_WORDS:
        return Head("due_on")
    without_brackets = plain_head(re.sub(r"\(.*?\)|\[.*?\]|（.*?）|［.*?］", " ", text))
    return Head(_FIELD_OF.get(without_brackets))


def _length_with_unit(words: Sequence[str]) -> Head | None:
    """Return the meaning of a length with its unit, as in Length (ms); None for any other head."""
    while words and words[0] in ABOUT_A_LENGTH:  # Max length (s)
        words = words[1:]
    base = next((count for count in range(len(words), 0, -1) if _is_length(words[:count])), 0)
    if not base:
        return None
    rest = [word for word in words[base:] if word not in ABOUT_A_LENGTH]
    if " ".join(rest) in CLOCKS or not rest:
        return Head("duration_s")
    if counted := next((_COUNTED[word] for word in rest if word in _COUNTED), ""):
        return Head("duration_s", counted=counted, note=f"a length in {counted}")
    if what := next((_OTHERS[word] for word in rest if word in _OTHERS), ""):
        return Head(None, note=f'"{" ".join(rest)}" is {what}, which is no length in seconds')
    units = {_UNITS[word] for word in rest if word in _UNITS}
    if len(units) == 1:
        return Head("duration_s", units.pop())
    return Head("duration_s", note=f'"{" ".join(rest)}" is no unit of time that is known; numbers are read as seconds')


def _is_length(words: Sequence[str]) -> bool:
    return _FIELD_OF.get(" ".join(words)) == "duration_s" and words[-1:] != ["sec"]


def known_heads_in(cells: Sequence[str]) -> int:
    """Return the number of known heads in a row's cells, each field counted once."""
    return len({head.field for cell in cells if cell.strip() and (head := head_of(cell)).field})
