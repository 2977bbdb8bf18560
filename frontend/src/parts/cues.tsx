import { type Peaks, WaveThumb } from '@/audio'
import type { Column, RowGroup } from '@/ui/Table'
import { Icon } from '@/ui/Icon'
import { SetBlocks } from '@/ui/SetBlocks'
import { StatusBadge, type StateKind, type Tone } from '@/ui/StatusBadge'

import { peaksOf, SAMPLES } from './sounds'

interface Cue {
  number: string
  name: string
  category: string
  use: string
  lengthS: string
  set: Tone[] | 'loop' | null
  peaks: Peaks | null
  state: StateKind
  stands: string
}

const thumb = (samples: Float32Array) => peaksOf(samples, 120)

export const CUES: RowGroup<Cue>[] = [
  {
    id: 'palette',
    head: (
      <>
        <span className="strong">Palette</span> <span className="small">2 of 2 accepted</span>
      </>
    ),
    rows: [
      {
        number: 'SW-003',
        name: 'laser_fire',
        category: 'weapon',
        use: 'Player’s turret, 5 a second',
        lengthS: '0.30',
        set: ['ok', 'ok', 'ok', 'ok'],
        peaks: thumb(SAMPLES.step),
        state: 'accepted',
        stands: '',
      },
      {
        number: 'SW-004',
        name: 'engine_idle_loop',
        category: 'vehicle',
        use: 'Own ship at rest',
        lengthS: '4.00',
        set: 'loop',
        peaks: thumb(SAMPLES.hum),
        state: 'accepted',
        stands: 'Seam level 0.2 dB, slope clean',
      },
    ],
  },
  {
    id: 'alpha',
    head: (
      <>
        <span className="strong">Alpha</span> <span className="small">0 of 4 accepted, due Friday 20 November</span>
      </>
    ),
    rows: [
      {
        number: 'SW-007',
        name: 'shield_hit',
        category: 'weapon',
        use: 'Enemy shot meets the shield',
        lengthS: '0.80',
        set: null,
        peaks: thumb(SAMPLES.shieldA),
        state: 'to_review',
        stands: 'Pick one of three.',
      },
      {
        number: 'SW-009',
        name: 'airlock_cycle',
        category: 'foley',
        use: 'Inner door opens and locks',
        lengthS: '2.00',
        set: null,
        peaks: thumb(SAMPLES.door),
        state: 'returned',
        stands: 'Peak 0.0 dBFS, limit −0.1',
      },
      {
        number: 'SW-012',
        name: 'thruster_burst',
        category: 'vehicle',
        use: 'Side thruster, short push',
        lengthS: '0.80',
        set: ['review', 'review', 'warn', 'review'],
        peaks: thumb(SAMPLES.shieldB),
        state: 'to_review',
        stands: '_03 is 4.0 dB louder than its set',
      },
      {
        number: 'SW-024',
        name: 'mine_arm',
        category: 'weapon',
        use: 'Mine wakes as a ship nears',
        lengthS: '0.50',
        set: null,
        peaks: null,
        state: 'cut',
        stands: 'Cut on 9 November, “mines left the game”',
      },
    ],
  },
]

const RESTING: readonly StateKind[] = ['accepted', 'cut', 'to_make', 'checking']

export const CUE_COLUMNS: Column<Cue>[] = [
  { id: 'number', head: 'Number', width: '70px', cell: ({ number }) => <span className="mono dim">{number}</span> },
  {
    id: 'name',
    head: 'Cue',
    width: '170px',
    narrow: 'name',
    rowHead: true,
    cell: ({ name, state }) => (
      <span className={state === 'cut' ? 'struck' : RESTING.includes(state) ? '' : 'strong'}>{name}</span>
    ),
  },
  { id: 'category', head: 'Category', width: '80px', cell: ({ category }) => <span className="mid">{category}</span> },
  { id: 'use', head: 'Use in the game', width: '190px', cell: ({ use }) => <span className="mid">{use}</span> },
  { id: 'length', head: 'Length, s', width: '64px', numeric: true, cell: ({ lengthS }) => lengthS },
  {
    id: 'set',
    head: 'Set or loop',
    width: '120px',
    narrow: 'set',
    cell: ({ set }) =>
      set === 'loop' ? (
        <span className="small mid">
          <Icon name="loop" /> loop
        </span>
      ) : (
        set && <SetBlocks blocks={set.map((tone) => ({ tone, odd: tone === 'warn' }))} />
      ),
  },
  { id: 'newest', head: 'Newest version', width: '124px', cell: ({ peaks }) => <WaveThumb peaks={peaks} /> },
  { id: 'state', head: 'State', width: '150px', narrow: 'state', cell: ({ state }) => <StatusBadge kind={state} /> },
  { id: 'stands', head: 'Latest', narrow: 'stands', cell: ({ stands }) => stands },
]
