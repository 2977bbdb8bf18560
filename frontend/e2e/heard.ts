/** What of the player is measured in a browser: bundled by the test, and run in a page of its own. */
export { outputOf } from '../src/audio/conditionNodes'
export { CONDITIONS } from '../src/audio/conditions'
export { direct } from '../src/audio/output'
export { Player } from '../src/audio/player'
