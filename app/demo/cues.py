"""The demo's sound list: what a space strategy game for PC and handheld asks for."""

from typing import Any

NOT_SETTLED = {"state": "concept"}
LOOP = {"loop": True}


def _cue(name: str, category: str, use: str, duration_s: float, **more: Any) -> dict[str, Any]:
    return {"name": name, "category": category, "use": use, "duration_s": duration_s, "state": "locked"} | more


CUES: list[dict[str, Any]] = [
    _cue("ui_confirm", "ui", "A choice is taken", 0.12, palette=True, description="Two short rising notes, glassy."),
    _cue("ui_back", "ui", "A choice is left", 0.12, palette=True, description="The confirm turned round: falling."),
    _cue(
        "laser_fire", "weapon", "Player’s turret, 5 a second", 0.30, variations=4, palette=True, playback_priority=2,
        description="Thin and bright, must not tire at 5 a second; no low end.",
    ),
    _cue(
        "engine_idle_loop", "vehicle", "Own ship at rest", 4.0, **LOOP, palette=True,
        description="A large reactor two decks down: steady, no melody.",
    ),
    _cue(
        "amb_bridge_loop", "ambience", "Under every bridge scene", 24.0, **LOOP, palette=True,
        description="Air, far relays, now and then a console; music plays over it.",
    ),
    _cue("hull_impact", "impact", "Debris meets the hull", 0.90, variations=3, palette=True,
         description="A stone of a few kilograms on plate steel, heard from inside."),
    _cue(
        "shield_hit", "weapon", "Enemy shot meets the shield", 0.80, reverb="dry", playback_priority=1,
        channels="mono", phase="alpha",
        description="An enemy shot meets the shield; must read over laser fire.", trigger="OnShieldHit",
    ),
    _cue("foot_deck_walk", "foley", "Crew on steel deck, walking", 0.40, variations=6,
         description="Rubber soles on a steel grating, one person, close."),
    _cue("airlock_cycle", "foley", "Inner door opens and locks", 2.0, description="Servo, slide, then a heavy bolt."),
    _cue("coolant_splash", "impact", "Something falls in the tank", 0.70, description="A splash in the tank."),
    _cue("suit_hit", "impact", "Shot meets a pressure suit", 0.50, description="Dull, padded, something hard inside."),
    _cue("thruster_burst", "vehicle", "Side thruster, short push", 0.80, variations=4,
         description="A short jet of gas; several may follow at once."),
    _cue("victory_sting", "music", "Fleet wins the sector", 3.0, description="Three rising chords, brass and glass."),
    _cue("radar_ping", "ui", "Sweep finds a ship", 0.60, description="One ping with a short tail of its own."),
    _cue("dock_clamp", "foley", "Clamps take the hull", 0.80, description="Two clamps, the second heavier."),
    _cue("explosion_far", "impact", "A ship dies far off", 2.5, description="Low, wide, no crack: it is far."),
    _cue("alarm_red_alert", "ui", "Bridge alarm until silenced", 2.0, **LOOP, placeholder=True,
         description="Urgent for ten seconds, bearable for a minute."),
    _cue(
        "warp_in", "vehicle", "Own ship arrives", 2.0, reverb="dry", phase="beta",
        description="Suction, then arrival.",
    ),
    _cue("missile_launch", "weapon", "Capital ship fires", 1.4, description="Release, ignition, departure."),
    _cue("vo_oath", "vo", "Captain swears in, English", 6.0, description="“By the light of a hundred suns.”"),
    _cue("void_whale", "creature", "Heard once, never seen", 9.0, **NOT_SETTLED,
         description="Larger than the ship. Nobody knows yet what it is."),
    _cue("amb_engine_room_loop", "ambience", "Engine room, lower deck", 30.0, **LOOP,
         description="Closer and hotter than the bridge."),
    _cue("drone_swarm_loop", "creature", "Swarm of 40, near", 6.0, **LOOP, state="prototype",
         description="Forty small machines; no single one stands out."),
    _cue("mine_arm", "weapon", "Mine wakes as a ship nears", 0.50, description="Three clicks and a hum."),
]  # fmt: skip
CHECKLISTS = {
    "": ["No clicks at either end", "Sits beside the palette", "Still good the tenth time"],
    "music": ["Loops without a gap"],
}
QUESTION = ("coolant_splash", "What falls in: a drop, a tool, a person?")
CHANGES = (
    ("suit_hit", "Add a dull metallic clank", 0.06),
    ("missile_launch", "More of the release before it goes", 0.10),
    ("mine_arm", "The third click comes too early", 0.20),
)
SECOND_CHANGE = ("missile_launch", "The thrust comes too late", 0.45)
THIRD_CHANGE = ("missile_launch", "Thrust comes too late; I want it at 0.3, not 0.5", 0.30)
CUT = ("mine_arm", "Mines left the game")
PALETTE = ("ui_confirm", "ui_back", "laser_fire", "engine_idle_loop", "amb_bridge_loop", "hull_impact")
ACCEPTED_OF_ALPHA = ("radar_ping", "dock_clamp", "explosion_far")
FOOTSTEPS, FOOTSTEPS_LOUDER_DB = "foot_deck_walk", 6.0  # accepted with them, and turned up in the game since
ALPHA = (
    *("shield_hit", "foot_deck_walk", "airlock_cycle", "coolant_splash", "suit_hit", "thruster_burst"),
    *("victory_sting", *ACCEPTED_OF_ALPHA),
)
BETA = (
    *("alarm_red_alert", "warp_in", "missile_launch", "vo_oath", "void_whale", "amb_engine_room_loop"),
    *("drone_swarm_loop", "mine_arm"),
)
DEPOSIT_MINOR = 144_000
MILESTONES = (("Palette", PALETTE, 24_000, 0), ("Alpha", ALPHA, 18_000, 3), ("Beta", BETA, 31_500, 31))
ESTIMATE_MIN = 120
DESCRIPTION = "Space strategy game for PC and handheld. Played on TV and headphones; music under every battle."
