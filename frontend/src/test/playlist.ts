import { people } from './project'

/** One sound of a playlist. */
export const aPlaylistTake = (id: string, name: string, more: object = {}) => ({
  take_id: id,
  cue_id: `c-${id}`,
  cue_label: 'SW-001',
  cue_name: name,
  category: '',
  variation: null,
  number: 2,
  label: null,
  state: 'conforming',
  may_approve: false,
  is_heard: true,
  picture_id: `p-${id}`,
  duration_s: 0.8,
  thumb: null,
  preview_url: `/v1/sounds/p-${id}/preview`,
  peaks_url: null,
  spectrum_url: null,
  ...more,
})

export const PLAYLIST = {
  id: 'l1',
  project_id: 'p1',
  name: 'Combat',
  edition: 4,
  made_by: people.producer,
  takes: [aPlaylistTake('t1', 'laser'), aPlaylistTake('t2', 'door'), aPlaylistTake('t3', 'steps')],
  position: { take_id: 't2', at_s: 0.4 },
  may_share: true,
  may_join: true,
}

/** A session in which nothing plays. */
export const LIVE = {
  sequence: 1,
  holder: null,
  is_holder: false,
  is_elsewhere: false,
  take_id: null,
  is_playing: false,
  position_s: 0,
  server_ms: Date.parse('2026-11-20T10:00:00Z'),
  present: [],
}
